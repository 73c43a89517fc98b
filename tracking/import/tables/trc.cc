// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "tracking/import/tables/formats.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

// The line of names and the line of values below it.
void ReadValues(TableLines* lines, MarkerTable* header) {
  Fields names, values;
  lines->Require("the names DataRate, Units, ...", &names);
  lines->Require("the values of DataRate, Units, ...", &values);
  for (size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
    if (names[i] == "DataRate") header->facts.frame_rate = RateOf(names[i], values[i], *lines);
    if (names[i] == "Units") header->facts.metres_per_unit = UnitOf(names[i], values[i], *lines);
    if (names[i] == "NumFrames") header->num_frames = ParseInteger(values[i]);
  }
}

}  // namespace

MarkerTable ReadTrcHeader(TableLines* lines) {
  MarkerTable header;
  Fields fields;
  lines->Next(&fields);
  lines->set_separator('\t');
  ReadValues(lines, &header);
  lines->Require("the line 'Frame#, Time' with the markers' names", &fields);
  if (fields.size() < 2 || !StartsWith(fields[0], "Frame") || fields[1] != "Time") {
    lines->Fail("expected 'Frame#', 'Time' and the markers' names, between tabs, found '" +
                fields[0] + "'");
  }
  header.frame_column = 0;
  header.time_column = 1;
  for (size_t column = 2; column < fields.size(); ++column) {
    if (fields[column].empty()) continue;
    header.markers.push_back({fields[column], "", false, {column, column + 1, column + 2}});
    header.num_columns = column + 3;
  }
  CheckMarkers(header.markers, "none", *lines);
  for (size_t i = 0; i < header.markers.size(); ++i) {
    if (header.markers[i].axes[0] == 2 + 3 * i) continue;
    lines->Fail(*header.markers[i].axes[0],
                fmt::format("'{}': expected three columns a marker", header.markers[i].name));
  }
  lines->Require("the line X1, Y1, Z1, ...", &fields);
  if (fields.size() < 3 || fields[2] != "X1") {
    lines->Fail("expected X1, Y1, Z1, ... below the markers' names");
  }
  return header;
}

}  // namespace clothfit
