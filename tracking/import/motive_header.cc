// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/motive_header.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Fields = std::vector<std::string>;

// Fields may be quoted; a quote inside quotes is doubled.
Fields SplitLine(std::string_view line) {
  Fields fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = std::string(TrimBlanks(field));
  return fields;
}

// Found by name, not by counting: notes of the take may hold commas.
const std::string* FindValue(const Fields& header, const std::string& name) {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() || found + 1 == header.end() ? nullptr : &*(found + 1);
}

void ParseTake(const Fields& header, const MotiveLines& lines, MotiveHeader* result) {
  if (header.front() != "Format Version") {
    lines.Fail(
        fmt::format("expected 'Format Version,...' as Motive exports it with its header, "
                    "found '{}'",
                    header.front()));
  }
  const std::string* rate = FindValue(header, "Export Frame Rate");
  if (rate == nullptr) rate = FindValue(header, "Capture Frame Rate");
  if (rate == nullptr) lines.Fail("'Export Frame Rate' is missing");
  result->frame_rate = ParseNumber(*rate).value_or(0.0);
  if (result->frame_rate <= 0.0) {
    lines.Fail(fmt::format("Export Frame Rate: expected a number above 0, found '{}'", *rate));
  }
  const std::string* const units = FindValue(header, "Length Units");
  if (units == nullptr) lines.Fail("'Length Units' is missing");
  const std::map<std::string, double> metres = {
      {"Meters", 1.0}, {"Centimeters", 1e-2}, {"Millimeters", 1e-3}};
  const auto unit = metres.find(*units);
  if (unit == metres.end()) {
    lines.Fail(fmt::format("Length Units: expected Meters, Centimeters or Millimeters, found '{}'",
                           *units));
  }
  result->metres_per_unit = unit->second;
}

// The rows that say what each column is, by the name that stands before them.
std::map<std::string, Fields> ReadColumnRows(MotiveLines* lines) {
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

void CheckMarkers(const std::vector<MarkerColumns>& markers, const std::set<std::string>& types,
                  const MotiveLines& lines) {
  if (std::all_of(markers.begin(), markers.end(),
                  [](const auto& one) { return one.is_expected; })) {
    const std::string found = JoinNames({types.begin(), types.end()});
    lines.Fail("expected columns of type Marker, found " + (found.empty() ? "none" : found));
  }
  std::set<std::pair<std::string, bool>> names;
  for (const MarkerColumns& marker : markers) {
    if (!names.emplace(marker.name, marker.is_expected).second)
      lines.Fail("two markers are named '" + marker.name + "'");
    for (size_t axis = 0; axis < 3; ++axis) {
      if (marker.axes.at(axis)) continue;
      lines.Fail(fmt::format("marker '{}' has no column {}", marker.name, "XYZ"[axis]));
    }
  }
}

}  // namespace

MotiveLines::MotiveLines(const std::filesystem::path& file)
    : file_(file), text_(ReadTextFile(file)), rest_(text_) {
  if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
}

bool MotiveLines::Next(std::vector<std::string>* fields) {
  while (!rest_.empty()) {
    const size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = TrimBlanks(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (line.empty()) continue;
    *fields = SplitLine(line);
    return true;
  }
  return false;
}

void MotiveLines::Fail(const std::string& problem) const {
  throw InputError(fmt::format("{}: line {}", file_.string(), number_), problem);
}

void MotiveLines::Fail(size_t column, const std::string& problem) const {
  throw InputError(fmt::format("{}: line {}, column {}", file_.string(), number_, column + 1),
                   problem);
}

MotiveHeader ReadMotiveHeader(MotiveLines* lines) {
  MotiveHeader header;
  Fields fields = {""};
  lines->Next(&fields);
  ParseTake(fields, *lines, &header);
  std::map<std::string, Fields> rows = ReadColumnRows(lines);
  header.num_columns = rows["axis"].size();
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
  CheckMarkers(markers, types, *lines);
  return header;
}

}  // namespace clothfit
