// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers made small enough for a page: quantised, differenced in time, deflated, as base64.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

// The 16-bit value that stands for "not known".
inline constexpr std::uint16_t kNoValue = 65535;

// Values over a box: number q of component c is lower[c] + q / 65534 (upper[c] - lower[c]).
struct Quantised {
  std::vector<std::uint16_t> values;
  std::vector<double> lower, upper;  // one a component
};

// `values` holds the components of one item after the other. A value that is not finite becomes
// kNoValue; the others are off by at most half a step, 1/131068 of their component's range.
Quantised Quantise(const std::vector<double>& values, int components);
double Unquantise(const Quantised& quantised, std::size_t index);

// Rows of `row` integers: each row minus the one before it (modulo 2^16 or 2^32), then all lowest
// bytes, all second ones and so on, as a zlib stream (RFC 1950). Smooth motion comes to about a
// byte a number.
std::string PackRows(const std::vector<std::uint16_t>& values, std::size_t row);
std::string PackRows(const std::vector<std::int32_t>& values, std::size_t row);

// RFC 4648, section 4.
std::string Base64(std::string_view bytes);

}  // namespace clothfit
