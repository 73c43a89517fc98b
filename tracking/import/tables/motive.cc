// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/base/names.h"
#include "tracking/import/tables/formats.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

// Found by name, not by counting: notes of the take may hold commas.
const std::string* FindValue(const Fields& header, const std::string& name) {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() || found + 1 == header.end() ? nullptr : &*(found + 1);
}

TakeFacts ParseTake(const Fields& header, const TableLines& lines) {
  TakeFacts facts;
  const std::string* rate = FindValue(header, "Export Frame Rate");
  if (rate == nullptr) rate = FindValue(header, "Capture Frame Rate");
  if (rate == nullptr) lines.Fail("'Export Frame Rate' is missing");
  facts.frame_rate = RateOf("Export Frame Rate", *rate, lines);
  const std::string* const units = FindValue(header, "Length Units");
  if (units == nullptr) lines.Fail("'Length Units' is missing");
  facts.metres_per_unit = UnitOf("Length Units", *units, lines);
  facts.up = "y";
  return facts;
}

// The rows that say what each column is, by the name that stands before them.
std::map<std::string, Fields> ReadColumnRows(TableLines* lines) {
  std::map<std::string, Fields> rows;
  Fields fields;
  while (lines->Next(&fields)) {
    if (fields.front() == "Frame") {
      rows["axis"] = fields;
      break;
    }
    const bool is_quantity = std::count(fields.begin(), fields.end(), "Position") > 0;
    const std::string& label = fields.size() > 1 && fields[0].empty() ? fields[1] : fields[0];
    rows[is_quantity ? "quantity" : label] = fields;
  }
  if (rows.count("axis") == 0) lines->Fail("expected a row 'Frame,Time (Seconds),X,Y,Z,...'");
  const size_t width = rows["axis"].size();
  for (const char* name : {"Type", "Name", "ID", "quantity"}) {
    Fields& row = rows[name];  // an ID or a quantity may lack
    if (row.empty() && (name[0] == 'T' || name[0] == 'N')) {
      lines->Fail(fmt::format("the row '{}' is missing above this one", name));
    }
    row.resize(std::max(row.size(), width));
  }
  return rows;
}

}  // namespace

MarkerTable ReadMotiveHeader(TableLines* lines) {
  MarkerTable header;
  Fields fields = {""};
  lines->Next(&fields);
  header.facts = ParseTake(fields, *lines);
  std::map<std::string, Fields> rows = ReadColumnRows(lines);
  header.num_columns = rows["axis"].size();
  header.frame_column = 0;
  header.time_column = 1;
  std::vector<MarkerColumns>& markers = header.markers;
  std::set<std::string> types;
  for (size_t column = 2; column < header.num_columns; ++column) {
    const std::string& type = rows["Type"][column];
    if (!type.empty()) types.insert(type);
    const std::string& axis = rows["axis"][column];
    const std::string& quantity = rows["quantity"][column];
    const std::string& name = rows["Name"][column];
    const bool is_expected = type == "Rigid Body Marker";
    const bool is_axis = axis == "X" || axis == "Y" || axis == "Z";
    if (type == "Rigid Body") header.bodies.insert(name);
    if ((type != "Marker" && !is_expected) || !is_axis) continue;
    if (!quantity.empty() && quantity != "Position") continue;
    const std::string& id = rows["ID"][column];
    const auto known = std::find_if(markers.begin(), markers.end(), [&](const MarkerColumns& one) {
      return one.name == name && one.id == id && one.is_expected == is_expected;
    });
    MarkerColumns& marker = known == markers.end()
                                ? markers.emplace_back(MarkerColumns{name, id, is_expected, {}})
                                : *known;
    marker.axes.at(static_cast<size_t>(axis[0] - 'X')) = column;
  }
  CheckMarkers(markers, types.empty() ? "none" : JoinNames({types.begin(), types.end()}), *lines);
  return header;
}

}  // namespace clothfit
