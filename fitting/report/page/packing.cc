// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include <zlib.h>

namespace clothfit {
namespace {

constexpr double kSteps = 65534.0;

std::string Deflate(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw std::runtime_error("zlib cannot deflate a block of the report");
  packed.resize(size);
  return packed;
}

template <class T>
std::string PackIntegers(const std::vector<T>& values, std::size_t row) {
  using Unsigned = std::make_unsigned_t<T>;
  std::string planes(values.size() * sizeof(T), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto before = static_cast<Unsigned>(i < row ? T{0} : values[i - row]);
    const auto difference = static_cast<Unsigned>(static_cast<Unsigned>(values[i]) - before);
    for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
      planes[plane * values.size() + i] = static_cast<char>((difference >> (8 * plane)) & 0xff);
    }
  }
  return Deflate(planes);
}

}  // namespace

Quantised Quantise(const std::vector<double>& values, int components) {
  const auto width = static_cast<std::size_t>(components);
  Quantised result;
  result.lower.assign(width, std::numeric_limits<double>::infinity());
  result.upper.assign(width, -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    result.lower[i % width] = std::min(result.lower[i % width], values[i]);
    result.upper[i % width] = std::max(result.upper[i % width], values[i]);
  }
  for (std::size_t c = 0; c < width; ++c) {
    if (result.lower[c] > result.upper[c]) result.lower[c] = result.upper[c] = 0.0;  // none known
  }
  result.values.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double range = result.upper[i % width] - result.lower[i % width];
    const double share = range > 0.0 ? (values[i] - result.lower[i % width]) / range : 0.0;
    result.values.push_back(std::isfinite(values[i])
                                ? static_cast<std::uint16_t>(std::lround(kSteps * share))
                                : kNoValue);
  }
  return result;
}

double Unquantise(const Quantised& quantised, std::size_t index) {
  const std::size_t c = index % quantised.lower.size();
  const std::uint16_t value = quantised.values[index];
  if (value == kNoValue) return std::numeric_limits<double>::quiet_NaN();
  return quantised.lower[c] + value / kSteps * (quantised.upper[c] - quantised.lower[c]);
}

std::string PackRows(const std::vector<std::uint16_t>& values, std::size_t row) {
  return PackIntegers(values, row);
}

std::string PackRows(const std::vector<std::int32_t>& values, std::size_t row) {
  return PackIntegers(values, row);
}

std::string Base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += i + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return text;
}

}  // namespace clothfit
