// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace clothfit {
namespace {

// Reads the whole of the text as a number; from_chars knows no leading plus.
template <class Number>
std::optional<Number> ParseWhole(std::string_view text) {
  text = TrimBlanks(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  if (text.empty() || result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text) {
  const std::optional<double> value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> ParseInteger(std::string_view text) { return ParseWhole<int>(text); }

std::string FormatNumber(double value) {
  std::array<char, 32> buffer;
  const std::to_chars_result result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::string QuantityInWords(double value, const std::string& unit) {
  const bool is_length = unit == "m";
  const double shown = is_length ? 1e3 * value : value;
  const int digits = std::abs(shown) >= 10.0 ? 0 : std::abs(shown) >= 1.0 ? 1 : 2;
  return fmt::format("{:.{}f} {}", shown, digits, is_length ? "mm" : unit);
}

std::string Capitalised(std::string words) {
  if (!words.empty())
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string AsSentence(std::string words) {
  words = Capitalised(std::move(words));
  if (!words.empty() && words.back() != '.') words += '.';
  return words;
}

std::string_view TrimBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace clothfit
