// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of a CSV file of OptiTrack Motive, and the header that says what its columns are.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

// The lines of the file, one at a time.
class MotiveLines {
 public:
  explicit MotiveLines(const std::filesystem::path& file);
  MotiveLines(const MotiveLines&) = delete;
  MotiveLines& operator=(const MotiveLines&) = delete;

  // The fields of the next line that is not empty; false at the end.
  bool Next(std::vector<std::string>* fields);

  // An InputError at the line last read, and at one of its fields, counted from 0.
  [[noreturn]] void Fail(const std::string& problem) const;
  [[noreturn]] void Fail(size_t column, const std::string& problem) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  std::string_view rest_;
  int number_ = 0;  // of the line last read, from 1
};

// Where a marker's coordinates stand in a row.
struct MarkerColumns {
  std::string name, id;
  bool is_expected = false;  // where a rigid body that was found has it; not measured
  std::array<std::optional<size_t>, 3> axes;  // X, Y, Z; all there once the header was read
};

struct MotiveHeader {
  double frame_rate = 0.0;  // Hz
  double metres_per_unit = 1.0;
  size_t num_columns = 0;
  std::vector<MarkerColumns> markers;  // of type Marker, at least one, and Rigid Body Marker
  std::set<std::string> bodies;        // names in columns of type Rigid Body
};

// Reads up to the row "Frame,Time (Seconds),...", after which the data begin.
MotiveHeader ReadMotiveHeader(MotiveLines* lines);

}  // namespace clothfit
