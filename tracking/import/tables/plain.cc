// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "tracking/import/tables/formats.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// "left_x": the name, and 0 for x; empty for what is no coordinate.
std::optional<std::pair<std::string, size_t>> NameAndAxis(const std::string& field) {
  if (field.size() < 3) return std::nullopt;
  const size_t axis = std::string("xyz").find(Lower(field).back());
  const char before = field[field.size() - 2];
  if (axis == std::string::npos || std::string("_.: ").find(before) == std::string::npos) {
    return std::nullopt;
  }
  return std::pair(field.substr(0, field.size() - 2), axis);
}

void AddCoordinate(const std::string& name, size_t axis, size_t column, const TableLines& lines,
                   std::vector<MarkerColumns>* markers) {
  const auto known = std::find_if(markers->begin(), markers->end(),
                                  [&](const MarkerColumns& one) { return one.name == name; });
  MarkerColumns& marker =
      known == markers->end() ? markers->emplace_back(MarkerColumns{name, "", false, {}}) : *known;
  if (marker.axes.at(axis)) {
    lines.Fail(column, fmt::format("marker '{}' has two columns {}", name, "xyz"[axis]));
  }
  marker.axes.at(axis) = column;
}

}  // namespace

MarkerTable ReadPlainHeader(TableLines* lines, std::vector<std::string>* notes) {
  MarkerTable header;
  Fields fields = {""};
  lines->set_separator(lines->LikelySeparator());
  lines->Next(&fields);
  header.num_columns = fields.size();
  std::vector<std::string> ignored;
  for (size_t column = 0; column < fields.size(); ++column) {
    if (const auto found = NameAndAxis(fields[column])) {
      AddCoordinate(found->first, found->second, column, *lines, &header.markers);
    } else if (Lower(fields[column]) == "frame") {
      header.frame_column = column;
    } else if (Lower(fields[column]) == "time") {
      header.time_column = column;
    } else if (!fields[column].empty()) {
      ignored.push_back(fields[column]);
    }
  }
  if (header.markers.empty()) {
    lines->Fail(
        "expected C3D, TRC, an export of OptiTrack Motive, Vicon Nexus or Qualisys, or a table "
        "that "
        "begins with 'frame,left_x,left_y,left_z,...' or 'time,left_x,...'");
  }
  CheckMarkers(header.markers, "none", *lines);
  if (!ignored.empty()) notes->push_back("columns that are left out: " + JoinNames(ignored));
  return header;
}

}  // namespace clothfit
