// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "tracking/import/tables/formats.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

constexpr std::string_view kSection = "Trajectories";

// Where the section's line begins, in a file in which others may come first.
size_t FindSection(std::string_view text) {
  if (StartsWith(text, "\xEF\xBB\xBF")) return FindSection(text.substr(3));
  for (size_t at = 0; at < text.size();) {
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    const bool is_it = line.substr(0, kSection.size()) == kSection &&
                       line.substr(kSection.size()).find_first_not_of(",;\t\r ") == line.npos;
    if (is_it) return at;
    at += line.size() + 1;
  }
  return text.npos;
}

}  // namespace

bool IsVicon(std::string_view text) { return FindSection(text) != text.npos; }

MarkerTable ReadViconHeader(TableLines* lines) {
  MarkerTable header;
  header.frame_column = 0;
  header.ends_at_empty_line = true;
  Fields names, axes, units;
  do {
    lines->set_separator(lines->LikelySeparator());
    lines->Require("a line 'Trajectories'", &names);
  } while (names[0] != kSection);
  lines->Require("the rate of the trajectories", &names);
  header.facts.frame_rate = RateOf("Trajectories: rate", names[0], *lines);
  lines->set_separator(lines->LikelySeparator());
  lines->Require("the markers' names", &names);
  lines->Require("'Frame, Sub Frame, X, Y, Z, ...'", &axes);
  if (axes[0] != "Frame") {
    lines->Fail("Trajectories: expected 'Frame, Sub Frame, X, Y, Z, ...', found '" + axes[0] + "'");
  }
  lines->Require("the units", &units);
  names.resize(std::max(names.size(), axes.size()));
  units.resize(std::max(units.size(), axes.size()));
  header.num_columns = axes.size();
  for (size_t column = 2; column + 2 < axes.size(); ++column) {
    const bool is_place = axes[column] == "X" && axes[column + 1] == "Y" && axes[column + 2] == "Z";
    if (!is_place) continue;
    const std::string& name = names[column];
    if (name.empty()) lines->Fail(column, "Trajectories: expected a name above this marker");
    header.markers.push_back({name, "", false, {column, column + 1, column + 2}});
    header.facts.metres_per_unit = UnitOf("Trajectories: unit", units[column], *lines);
  }
  CheckMarkers(header.markers, "none", *lines);
  return header;
}

}  // namespace clothfit
