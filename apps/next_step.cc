// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/next_step.h"

#include <cctype>
#include <cstring>

#include <fmt/format.h>

namespace clothfit {

void PrintNext(const std::string& text) { fmt::print("next: {}\n", text); }

std::string ShellWord(const std::string& path) {
  bool is_plain = !path.empty();
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    is_plain = is_plain &&
               (std::isalnum(byte) != 0 || byte >= 0x80 || std::strchr("_-./:=,@%+", c) != nullptr);
  }
  if (is_plain) return path;
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace clothfit
