// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables as comma separated values: one header line, `.` decimals, a missing number is an empty
// field. No quoting. Lines may end in CR LF; a byte order mark and empty lines are passed over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// Rows of a table: the markers of an hour of motion capture, 50 at 240 Hz. Each becomes some 200
// bytes of a recording.
inline constexpr std::size_t kMostTableRows = 45'000'000;

// One row while it is being read. Columns are counted in the order that the caller asked for, not
// in that of the file. Everything throws InputError naming the file, the line and the column.
class CsvRow {
 public:
  double Number(size_t column) const;
  int Integer(size_t column) const;
  std::string Text(size_t column) const;  // not empty
  Eigen::Vector2d Vector2(size_t first_column) const;
  Eigen::Vector3d Vector3(size_t first_column) const;

  // True when all of these fields are empty; an error when only some are.
  bool IsMissing(size_t first_column, size_t count) const;

  int line() const { return line_; }  // in the file, from 1; the header is line 1
  [[noreturn]] void Fail(const std::string& problem) const;
  [[noreturn]] void Fail(size_t column, const std::string& problem) const;

 private:
  friend void ReadCsv(const std::filesystem::path&, const std::vector<std::string>&,
                      const std::function<void(const CsvRow&)>&, std::size_t);
  const std::filesystem::path* file_ = nullptr;
  const std::vector<std::string>* columns_ = nullptr;
  int line_ = 0;
  std::vector<std::string_view> fields_;
};

// Calls visit for each row. The header must name exactly these columns, in any order.
void ReadCsv(const std::filesystem::path& file, const std::vector<std::string>& columns,
             const std::function<void(const CsvRow&)>& visit,
             std::size_t most_rows = kMostTableRows);

}  // namespace clothfit
