// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace clothfit {
namespace {

// One character of UTF-8, and its bytes; 0 bytes where the text begins with none.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

Character FirstCharacter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast.at(bytes) || code > 0x10ffff || is_surrogate) return {};
  return {code, bytes};
}

bool IsShown(std::uint32_t code) {
  const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool breaks_lines = code == 0x2028 || code == 0x2029;
  const bool turns = code == 0x200e || code == 0x200f || code == 0x61c ||
                     (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !is_control && !breaks_lines && !turns && code != 0xfeff;
}

std::string Escaped(const char* format, std::uint32_t code) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, static_cast<unsigned>(code));
  return text.data();
}

// Whole characters from the beginning, of at most so many bytes as shown.
std::string Beginning(std::string_view text, std::size_t most) {
  std::string shown;
  while (!text.empty()) {
    const Character next = FirstCharacter(text);
    std::string one;
    if (next.bytes == 0) {
      one = Escaped("\\x%02x", static_cast<unsigned char>(text[0]));
    } else if (next.code == '\n' || next.code == '\r' || next.code == '\t') {
      one = " ";
    } else if (IsShown(next.code)) {
      one = text.substr(0, next.bytes);
    } else {
      one = Escaped(next.code < 0x80 ? "\\x%02x" : "\\u%04x", next.code);
    }
    if (shown.size() + one.size() > most) break;
    shown += one;
    text.remove_prefix(next.bytes == 0 ? 1 : next.bytes);
  }
  return shown;
}

}  // namespace

std::string Printable(std::string_view text, std::size_t most) {
  if (text.size() <= most) {
    const std::string whole = Beginning(text, 8 * most);
    if (whole.size() <= most) return whole;
  }
  const std::size_t end = most / 3;
  std::string_view last = text.substr(text.size() - std::min(end, text.size()));
  // Not from the middle of a character on.
  while (!last.empty() && (static_cast<unsigned char>(last[0]) & 0xc0U) == 0x80U)
    last.remove_prefix(1);
  return Beginning(text, most - end) + " ... " + Beginning(last, end);
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kMost = 120;
  return "'" + Printable(text, kMost) + "'";
}

}  // namespace clothfit
