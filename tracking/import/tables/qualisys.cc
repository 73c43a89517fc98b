// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "tracking/import/tables/formats.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

void ReadValue(const Fields& fields, const TableLines& lines, MarkerTable* header) {
  const std::string& key = fields[0];
  const std::string value = fields.size() > 1 ? fields[1] : "";
  if (key == "NO_OF_FRAMES") header->num_frames = ParseInteger(value);
  if (key == "FREQUENCY") header->facts.frame_rate = RateOf(key, value, lines);
  if (key == "DATA_INCLUDED" && value != "3D") {
    lines.Fail(1, fmt::format("DATA_INCLUDED: expected 3D, found '{}'; export 3D data", value));
  }
}

// In the order of the names, from this column on.
void PlaceMarkers(const Fields& names, size_t first_column, MarkerTable* header) {
  size_t column = first_column;
  for (const std::string& name : names) {
    header->markers.push_back({name, "", false, {column, column + 1, column + 2}});
    column += 3;
  }
  header->num_columns = column;
}

}  // namespace

MarkerTable ReadQualisysHeader(TableLines* lines) {
  MarkerTable header;
  header.facts.metres_per_unit = 1e-3;
  header.zeros_are_lost = true;
  lines->set_separator('\t');
  Fields fields;
  do {
    lines->Require("a line 'MARKER_NAMES'", &fields);
    ReadValue(fields, *lines, &header);
  } while (fields[0] != "MARKER_NAMES");
  Fields names(fields.begin() + 1, fields.end());
  while (!names.empty() && names.back().empty()) names.pop_back();
  if (lines->BeginsWith("TRAJECTORY_TYPES")) lines->Next(&fields);
  if (lines->BeginsWith("Frame\tTime\t")) {
    lines->Next(&fields);
    header.frame_column = 0;
    header.time_column = 1;
  }
  PlaceMarkers(names, header.frame_column ? 2 : 0, &header);
  CheckMarkers(header.markers, "none", *lines);
  return header;
}

}  // namespace clothfit
