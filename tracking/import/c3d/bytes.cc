// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/c3d/bytes.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

// VAX F: the sign, 8 bits of exponent and 23 of a fraction between 1/2 and 1, most significant
// word first.
double VaxFloat(unsigned high, unsigned low) {
  const unsigned exponent = (high >> 7U) & 0xFFU;
  const unsigned fraction = ((high & 0x7FU) << 16U) | low;
  const bool is_negative = (high & 0x8000U) != 0;
  if (exponent == 0) return is_negative ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  const double value =
      std::ldexp(0.5 + std::ldexp(double(fraction), -24), static_cast<int>(exponent) - 128);
  return is_negative ? -value : value;
}

}  // namespace

void C3dBytes::Fail(size_t at, const std::string& problem) const {
  throw InputError(fmt::format("{}: byte {}", file_.string(), at), problem);
}

std::string_view C3dBytes::Text(size_t at, size_t count) const {
  if (at > bytes_.size() || count > bytes_.size() - at) {
    Fail(bytes_.size(), fmt::format("the file ends; expected {} bytes from {} on", count, at));
  }
  return bytes_.substr(at, count);
}

int C3dBytes::Byte(size_t at) const { return static_cast<unsigned char>(Text(at, 1)[0]); }

int C3dBytes::Word(size_t at) const {
  const std::string_view two = Text(at, 2);
  const int first = static_cast<unsigned char>(two[0]);
  const int second = static_cast<unsigned char>(two[1]);
  return processor_ == C3dProcessor::kMips ? 256 * first + second : first + 256 * second;
}

int C3dBytes::SignedWord(size_t at) const {
  const int word = Word(at);
  return word < 0x8000 ? word : word - 0x10000;
}

double C3dBytes::Float(size_t at) const {
  const auto first = static_cast<unsigned>(Word(at));
  const auto second = static_cast<unsigned>(Word(at + 2));
  if (processor_ == C3dProcessor::kDec) return VaxFloat(first, second);
  const bool is_mips = processor_ == C3dProcessor::kMips;
  const std::uint32_t bits = is_mips ? (first << 16U) | second : (second << 16U) | first;
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof(value));
  return double(value);
}

}  // namespace clothfit
