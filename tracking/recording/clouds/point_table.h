// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Points in a table of numbers of stated types, as PLY and PCD files have them: rows of text, or of
// bytes one after the other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

struct PointTable {
  enum class Encoding { kText, kLittleEndian, kBigEndian };
  struct Column {
    std::string name;
    char kind = 'F';  // F: floating, I: integer, U: integer without a sign
    int bytes = 4;    // of one number in a binary table; 1, 2, 4 or 8
    int count = 1;    // numbers that the column has
  };
  std::vector<Column> columns;
  std::int64_t num_rows = 0;
  Encoding encoding = Encoding::kText;
  std::string_view data;  // from the first row on
  int first_line = 1;     // of the data in the file, where it is text
};

// x, y and z of each row; a row of which one is not a finite number is no point, and is left out.
// Throws InputError, naming the file and the line or row, where x, y or z is not there, data is cut
// off, or text is no number.
std::vector<Eigen::Vector3d> PointsOf(const PointTable& table, const std::filesystem::path& file);

// Bytes of a row of a binary table.
std::int64_t BytesOfRow(const PointTable& table);

}  // namespace clothfit
