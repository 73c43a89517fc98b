// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/share_display.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/terminal.h"

namespace clothfit {

ShareDisplay::ShareDisplay() : is_terminal_(isatty(fileno(Terminal())) != 0) {}

void ShareDisplay::Show(double share, const std::string& stage) {
  // s between lines; a file is read later, a terminal now.
  const double interval = is_terminal_ ? 0.2 : 10.0;
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < interval) return;
  last_ = now;
  const std::string text = fmt::format("{:3.0f} %  {}", 100.0 * share, stage);
  if (is_terminal_) {
    std::fprintf(Terminal(), "\r\x1b[K%s", text.c_str());  // erase to the end of the line
    std::fflush(Terminal());
    has_line_ = true;
  } else {
    std::fprintf(Terminal(), "%s\n", text.c_str());
  }
}

void ShareDisplay::Finish() {
  if (has_line_) std::fputc('\n', Terminal());
  has_line_ = false;
}

}  // namespace clothfit
