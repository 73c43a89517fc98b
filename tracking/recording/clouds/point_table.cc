// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/clouds/point_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"

namespace clothfit {
namespace {

// What stands before x, y and z in a row: numbers in text, bytes in a binary table.
struct NumberPlace {
  int numbers = -1;
  std::int64_t bytes = 0;
  char kind = 'F';
  int size = 4;
};

std::array<NumberPlace, 3> PlacesOfPoint(const PointTable& table,
                                         const std::filesystem::path& file) {
  std::array<NumberPlace, 3> places;
  int numbers = 0;
  std::int64_t bytes = 0;
  for (const PointTable::Column& column : table.columns) {
    const std::size_t axis = std::string_view("xyz").find(column.name);
    if (column.name.size() == 1 && axis < 3)
      places[axis] = {numbers, bytes, column.kind, column.bytes};
    numbers += column.count;
    bytes += static_cast<std::int64_t>(column.bytes) * column.count;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (places[axis].numbers >= 0) continue;
    throw InputError(file.string(), fmt::format("has no {} of its points; expected x, y and z",
                                                std::string_view("xyz")[axis]));
  }
  return places;
}

template <class Number>
double NumberAt(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof(number));
  return static_cast<double>(number);
}

// `bytes` in this machine's order.
double Decode(char kind, int size, const char* bytes) {
  if (kind == 'F') return size == 8 ? NumberAt<double>(bytes) : NumberAt<float>(bytes);
  const bool has_sign = kind == 'I';
  switch (size) {
    case 1:
      return has_sign ? NumberAt<std::int8_t>(bytes) : NumberAt<std::uint8_t>(bytes);
    case 2:
      return has_sign ? NumberAt<std::int16_t>(bytes) : NumberAt<std::uint16_t>(bytes);
    case 4:
      return has_sign ? NumberAt<std::int32_t>(bytes) : NumberAt<std::uint32_t>(bytes);
    default:
      return has_sign ? NumberAt<std::int64_t>(bytes) : NumberAt<std::uint64_t>(bytes);
  }
}

std::vector<Eigen::Vector3d> PointsOfBytes(const PointTable& table,
                                           const std::array<NumberPlace, 3>& places,
                                           const std::filesystem::path& file) {
  const std::int64_t row_bytes = BytesOfRow(table);
  if (static_cast<std::int64_t>(table.data.size()) / row_bytes < table.num_rows) {
    throw InputError(file.string(), fmt::format("is cut off: expected {} points of {} bytes, found "
                                                "{} bytes",
                                                table.num_rows, row_bytes, table.data.size()));
  }
  std::vector<Eigen::Vector3d> points;
  for (std::int64_t row = 0; row < table.num_rows; ++row) {
    Eigen::Vector3d point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const NumberPlace& place = places[axis];
      const char* const number = table.data.data() + row * row_bytes + place.bytes;
      const bool is_reversed = table.encoding == PointTable::Encoding::kBigEndian;
      std::array<char, 8> bytes{};
      for (int i = 0; i < std::min(place.size, 8); ++i)
        bytes[static_cast<std::size_t>(i)] = number[is_reversed ? place.size - 1 - i : i];
      point[static_cast<Eigen::Index>(axis)] = Decode(place.kind, place.size, bytes.data());
    }
    if (point.allFinite()) points.push_back(point);
  }
  return points;
}

// The next number of a line, NaN and infinity among them; takes it off.
double TakeNumber(std::string_view* line, const std::string& place) {
  constexpr std::string_view kBlanks = " \t\r,";
  line->remove_prefix(std::min(line->find_first_not_of(kBlanks), line->size()));
  const std::string_view word = line->substr(0, line->find_first_of(kBlanks));
  line->remove_prefix(word.size());
  double value = 0.0;
  const std::size_t plus = word.size() > 1 && word[0] == '+' ? 1 : 0;
  const auto result = std::from_chars(word.data() + plus, word.data() + word.size(), value);
  if (word.empty()) throw InputError(place, "has too few numbers");
  if (result.ec != std::errc() || result.ptr != word.data() + word.size())
    throw InputError(place, "expected a number, found " + Quoted(word));
  return value;
}

std::vector<Eigen::Vector3d> PointsOfText(const PointTable& table,
                                          const std::array<NumberPlace, 3>& places,
                                          const std::filesystem::path& file) {
  int numbers = 0;
  for (const PointTable::Column& column : table.columns) numbers += column.count;
  std::vector<Eigen::Vector3d> points;
  std::string_view rest = table.data;
  int line_number = table.first_line;
  for (std::int64_t row = 0; row < table.num_rows; ++row, ++line_number) {
    if (rest.empty()) {
      throw InputError(file.string(), fmt::format("is cut off: expected {} points, found {}",
                                                  table.num_rows, row));
    }
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const std::string place = fmt::format("{}: line {}", file.string(), line_number);
    Eigen::Vector3d point;
    for (int n = 0; n < numbers; ++n) {
      const double value = TakeNumber(&line, place);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (places[axis].numbers == n) point[static_cast<Eigen::Index>(axis)] = value;
    }
    if (point.allFinite()) points.push_back(point);
  }
  return points;
}

}  // namespace

std::int64_t BytesOfRow(const PointTable& table) {
  std::int64_t bytes = 0;
  for (const PointTable::Column& column : table.columns)
    bytes += static_cast<std::int64_t>(column.bytes) * column.count;
  return bytes;
}

std::vector<Eigen::Vector3d> PointsOf(const PointTable& table, const std::filesystem::path& file) {
  const std::array<NumberPlace, 3> places = PlacesOfPoint(table, file);
  return table.encoding == PointTable::Encoding::kText ? PointsOfText(table, places, file)
                                                       : PointsOfBytes(table, places, file);
}

}  // namespace clothfit
