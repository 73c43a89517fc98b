// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/motive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/motive_header.h"
#include "tracking/import/rigid_body.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// One row of the data. Markers that are lost have empty fields.
struct Row {
  int number = 0;     // the file's own
  size_t frame = 0;   // from 0
  double time = 0.0;  // s
  std::vector<std::optional<Eigen::Vector3d>> positions;
};

std::optional<Eigen::Vector3d> PositionIn(const std::vector<std::string>& fields,
                                          const MarkerColumns& marker, const MotiveLines& lines) {
  Eigen::Vector3d position;
  int num_empty = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const std::string& field = fields[*marker.axes[axis]];
    num_empty += field.empty() ? 1 : 0;
    if (field.empty()) continue;
    const std::optional<double> value = ParseNumber(field);
    if (!value) {
      lines.Fail(*marker.axes[axis],
                 fmt::format("{} {}: expected a finite number or nothing, found '{}'", marker.name,
                             "XYZ"[axis], field));
    }
    position[static_cast<Eigen::Index>(axis)] = *value;
  }
  if (num_empty == 3) return std::nullopt;
  if (num_empty > 0) lines.Fail(marker.name + ": expected X, Y and Z or none of them");
  return position;
}

Row ReadRow(const std::vector<std::string>& fields, const MotiveHeader& header,
            const MotiveLines& lines) {
  if (fields.size() != header.num_columns) {
    lines.Fail(fmt::format("expected {} fields, found {}", header.num_columns, fields.size()));
  }
  Row row;
  const std::optional<int> number = ParseInteger(fields[0]);
  if (!number) lines.Fail("Frame: expected an integer, found '" + fields[0] + "'");
  row.number = *number;
  const std::optional<double> time = ParseNumber(fields[1]);
  if (!time) lines.Fail("Time (Seconds): expected a number, found '" + fields[1] + "'");
  row.time = *time;
  for (const MarkerColumns& marker : header.markers) {
    row.positions.push_back(PositionIn(fields, marker, lines));
  }
  return row;
}

// Sets the frames, which count from 0 and leave no number out where all were exported.
void CountFrames(const MotiveHeader& header, const MotiveLines& lines, std::vector<Row>* rows) {
  // Where fewer frames are exported than were captured, the numbers may go up by more than one.
  int stride = 0;
  for (const Row& row : *rows) stride = std::gcd(stride, row.number - rows->front().number);
  for (Row& row : *rows) {
    row.frame = static_cast<size_t>((row.number - rows->front().number) / std::max(stride, 1));
  }
  const double span = static_cast<double>(rows->back().frame) / header.frame_rate;
  const double given = rows->back().time - rows->front().time;
  constexpr double kTolerance = 0.01;  // of the span; times are rounded to a millisecond
  if (std::abs(given - span) > kTolerance * span + 2e-3) {
    lines.Fail(fmt::format("Time (Seconds): expected {:.3f} after {} frames at {} Hz, found {:.3f}",
                           rows->front().time + span, rows->back().frame, header.frame_rate,
                           rows->back().time));
  }
}

// The row, which comes after these.
Row ReadNext(const std::vector<std::string>& fields, const MotiveHeader& header,
             const std::vector<Row>& rows, const MotiveLines& lines) {
  Row row = ReadRow(fields, header, lines);
  if (!rows.empty() && row.number <= rows.back().number) {
    lines.Fail(
        fmt::format("Frame: expected more than {}, found {}", rows.back().number, row.number));
  }
  return row;
}

std::vector<Row> ReadRows(const MotiveHeader& header, bool skip_bad_rows, MotiveLines* lines,
                          std::vector<std::string>* notes) {
  std::vector<Row> rows;
  std::vector<std::string> fields, problems;
  while (lines->Next(&fields)) {
    try {
      rows.push_back(ReadNext(fields, header, rows, *lines));
    } catch (const InputError& error) {
      if (!skip_bad_rows) throw;
      problems.emplace_back(error.what());
    }
  }
  if (!problems.empty()) {
    notes->push_back(
        fmt::format("{} rows are skipped, the first: {}", problems.size(), problems.front()));
  }
  if (rows.empty()) lines->Fail("expected rows of data after the header, found none");
  CountFrames(header, *lines, &rows);
  return rows;
}

}  // namespace

MarkerTake ReadMotiveTake(const std::filesystem::path& file, const MotiveFileOptions& options,
                          std::vector<std::string>* notes) {
  MotiveLines lines(file);
  const MotiveHeader header = ReadMotiveHeader(&lines);
  const std::vector<Row> rows = ReadRows(header, options.skip_bad_rows, &lines, notes);
  Eigen::Matrix3d world_from_file = Eigen::Matrix3d::Identity();
  if (options.up == UpAxis::kY) world_from_file << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  MarkerTake take;
  take.file = file;
  take.frame_rate = header.frame_rate;
  std::vector<MarkerPath> expected;
  for (size_t i = 0; i < header.markers.size(); ++i) {
    MarkerPath path{header.markers[i].name, HandleDescription::Path(rows.back().frame + 1)};
    for (const Row& row : rows) {
      if (!row.positions[i]) continue;
      path.positions[row.frame] = header.metres_per_unit * (world_from_file * *row.positions[i]);
    }
    (header.markers[i].is_expected ? expected : take.markers).push_back(std::move(path));
  }
  TakeOutBodies(header.bodies, expected, &take);
  if (!take.markers.empty()) return take;
  throw InputError(file.string(), "expected markers of a cloth, found those of rigid bodies alone");
}

}  // namespace clothfit
