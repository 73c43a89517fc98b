// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/tables/formats.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// One row of the data. Markers that are lost have empty fields.
struct Row {
  int line = 0;       // in the file, from 1
  int number = 0;     // the file's own
  double time = 0.0;  // s
  size_t frame = 0;   // from 0
  std::vector<std::optional<Eigen::Vector3d>> positions;
};

bool IsLost(const std::string& field) {
  return field.empty() || field == "nan" || field == "NaN" || field == "NAN";
}

std::optional<Eigen::Vector3d> PositionIn(const std::vector<std::string>& fields,
                                          const MarkerColumns& marker, bool zeros_are_lost,
                                          const TableLines& lines) {
  Eigen::Vector3d position;
  int num_lost = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const std::string& field = fields[*marker.axes[axis]];
    num_lost += IsLost(field) ? 1 : 0;
    if (IsLost(field)) continue;
    const std::optional<double> value = ParseNumber(field);
    if (!value) {
      lines.Fail(*marker.axes[axis],
                 fmt::format("{} {}: expected a finite number or nothing, found '{}'", marker.name,
                             "XYZ"[axis], field));
    }
    position[static_cast<Eigen::Index>(axis)] = *value;
  }
  if (num_lost == 3) return std::nullopt;
  if (num_lost > 0) lines.Fail(marker.name + ": expected X, Y and Z or none of them");
  if (zeros_are_lost && position.isZero(0.0)) return std::nullopt;
  return position;
}

// A whole number; some programs write it as 12.000.
int NumberOfFrame(const std::string& field, size_t column, const TableLines& lines) {
  const double number = ParseNumber(field).value_or(0.5);
  constexpr double kMost = 2e9;
  if (std::trunc(number) != number || std::abs(number) > kMost) {
    lines.Fail(column, "Frame: expected an integer, found '" + field + "'");
  }
  return static_cast<int>(number);
}

// A separator too many at the end of a line is passed over. Where fields end at tabs, which some
// editors strip, markers that lack there are lost.
void FitWidth(size_t num_columns, const TableLines& lines, std::vector<std::string>* fields) {
  while (fields->size() > num_columns && fields->back().empty()) fields->pop_back();
  const bool lacks_markers =
      fields->size() < num_columns && (num_columns - fields->size()) % 3 == 0;
  if (lacks_markers && lines.separator() == '\t') fields->resize(num_columns);
  if (fields->size() == num_columns) return;
  lines.Fail(fmt::format("expected {} fields, found {}", num_columns, fields->size()));
}

// The row, which comes after these.
Row ReadNext(const std::vector<std::string>& fields, const MarkerTable& table,
             const std::vector<Row>& rows, const TableLines& lines) {
  Row row;
  row.line = lines.number();
  if (const auto& column = table.frame_column) {
    row.number = NumberOfFrame(fields[*column], *column, lines);
    if (!rows.empty() && row.number <= rows.back().number) {
      lines.Fail(*column, fmt::format("Frame: expected more than {}, found {}", rows.back().number,
                                      row.number));
    }
  }
  if (const auto& column = table.time_column) {
    const std::optional<double> time = ParseNumber(fields[*column]);
    if (!time) lines.Fail(*column, "Time: expected a number, found '" + fields[*column] + "'");
    row.time = *time;
    if (!rows.empty() && !table.frame_column && row.time <= rows.back().time) {
      lines.Fail(*column,
                 fmt::format("Time: expected more than {}, found {}", rows.back().time, row.time));
    }
  }
  for (const MarkerColumns& marker : table.markers) {
    row.positions.push_back(PositionIn(fields, marker, table.zeros_are_lost, lines));
  }
  return row;
}

void CheckSize(size_t num_frames, const MarkerTable& table, const TableLines& lines) {
  if (num_frames <= size_t{kMostFrames} && num_frames * table.markers.size() <= kMostPlaces) return;
  lines.Fail(
      fmt::format("expected at most {} frames, and {} places of markers, found {} frames of "
                  "{} markers",
                  kMostFrames, kMostPlaces, num_frames, table.markers.size()));
}

double MedianStep(const std::vector<Row>& rows) {
  std::vector<double> steps;
  for (size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].time - rows[i - 1].time);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Sets the frames by the numbers. Where a time says how long a frame is, numbers that all leave the
// same ones out are those of a capture of which fewer frames were exported.
void CountByNumber(const MarkerTable& table, const TableLines& lines, std::vector<Row>* rows,
                   std::optional<double>* rate) {
  const auto since_first = [&](const Row& row) {
    return static_cast<long long>(row.number) - rows->front().number;
  };
  long long stride = table.time_column ? 0 : 1;
  for (const Row& row : *rows) stride = std::gcd(stride, since_first(row));
  for (Row& row : *rows) {
    row.frame = static_cast<size_t>(since_first(row) / std::max(stride, 1LL));
  }
  if (!table.time_column) return;
  const double frames = static_cast<double>(rows->back().frame);
  const double given = rows->back().time - rows->front().time;
  if (!*rate && given > 0.0) *rate = frames / given;
  if (!*rate) return;
  const double span = frames / **rate;
  constexpr double kTolerance = 0.01;  // of the span; times are rounded to a millisecond
  if (std::abs(given - span) > kTolerance * span + 2e-3) {
    lines.Fail(fmt::format("Time: expected {:.3f} after {} frames at {:g} Hz, found {:.3f}",
                           rows->front().time + span, rows->back().frame, **rate,
                           rows->back().time));
  }
}

void CountByTime(const TableLines& lines, std::vector<Row>* rows, std::optional<double>* rate) {
  const double step = *rate ? 1.0 / **rate : MedianStep(*rows);
  if (!*rate && step > 0.0) *rate = 1.0 / step;
  for (Row& row : *rows) {
    const double frames = step > 0.0 ? (row.time - rows->front().time) / step : 0.0;
    constexpr double kTolerance = 0.25;  // of a frame
    if (frames > kMostFrames || std::abs(frames - std::round(frames)) > kTolerance) {
      lines.FailAt(row.line,
                   fmt::format("Time: expected frames at {:g} Hz from {} s on, found {} s",
                               1.0 / step, rows->front().time, row.time));
    }
    row.frame = static_cast<size_t>(std::lround(frames));
  }
}

std::vector<Row> ReadAll(const MarkerTable& table, bool skip_bad_rows, TableLines* lines,
                         std::vector<std::string>* notes) {
  std::vector<Row> rows;
  std::vector<std::string> fields, problems;
  int num_rows = 0;
  while (!(table.ends_at_empty_line && lines->IsEmptyNext()) && lines->Next(&fields)) {
    CheckSize(rows.size() + 1, table, *lines);
    ++num_rows;
    try {
      FitWidth(table.num_columns, *lines, &fields);
      rows.push_back(ReadNext(fields, table, rows, *lines));
    } catch (const InputError& error) {
      if (!skip_bad_rows) throw;
      problems.emplace_back(error.what());
      if (table.frame_column || table.time_column) continue;  // a gap in these
      rows.emplace_back();
      rows.back().positions.resize(table.markers.size());
    }
  }
  if (!problems.empty()) {
    notes->push_back(
        fmt::format("{} rows are skipped, the first: {}", problems.size(), problems.front()));
  }
  if (table.num_frames && *table.num_frames != num_rows) {
    notes->push_back(fmt::format("the header says {} frames, but {} rows are there",
                                 *table.num_frames, num_rows));
  }
  if (rows.empty()) lines->Fail("expected rows of data after the header, found none");
  return rows;
}

}  // namespace

double RateOf(const std::string& label, const std::string& text, const TableLines& lines) {
  const double rate = ParseNumber(text).value_or(0.0);
  if (rate > 0.0) return rate;
  lines.Fail(fmt::format("{}: expected a number above 0, found '{}'", label, text));
}

double UnitOf(const std::string& label, const std::string& text, const TableLines& lines) {
  if (const std::optional<double> metres = MetresPerUnit(text)) return *metres;
  lines.Fail(fmt::format("{}: expected m, cm or mm, found '{}'", label, text));
}

void CheckMarkers(const std::vector<MarkerColumns>& markers, const std::string& found,
                  const TableLines& lines) {
  if (std::all_of(markers.begin(), markers.end(),
                  [](const auto& one) { return one.is_expected; })) {
    lines.Fail("expected columns of markers, found " + found);
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

TakeInFile ReadRows(const MarkerTable& table, const TakeFileOptions& options, TableLines* lines,
                    std::vector<std::string>* notes) {
  std::vector<Row> rows = ReadAll(table, options.skip_bad_rows, lines, notes);
  TakeInFile take;
  take.facts = table.facts;
  std::optional<double>& rate = take.facts.frame_rate;
  if (options.facts.frame_rate) rate = options.facts.frame_rate;
  if (table.frame_column) {
    CountByNumber(table, *lines, &rows, &rate);
  } else if (table.time_column) {
    CountByTime(*lines, &rows, &rate);
  } else {
    for (size_t i = 0; i < rows.size(); ++i) rows[i].frame = i;
  }
  const size_t num_frames = rows.back().frame + 1;
  CheckSize(num_frames, table, *lines);
  take.bodies = table.bodies;
  for (size_t i = 0; i < table.markers.size(); ++i) {
    MarkerPath path{table.markers[i].name, HandleDescription::Path(num_frames)};
    for (const Row& row : rows) path.positions[row.frame] = row.positions[i];
    (table.markers[i].is_expected ? take.expected : take.markers).push_back(std::move(path));
  }
  return take;
}

}  // namespace clothfit
