// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/progress_display.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "apps/terminal.h"

namespace clothfit {
namespace {

constexpr double kPlainInterval = 10.0;  // s between plain lines of one stage
constexpr int kBarWidth = 20;

size_t TerminalWidth() {
  constexpr size_t kUsual = 80;
  winsize size{};
  const bool is_known = ioctl(fileno(Terminal()), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsual;
}

std::string Minutes(double seconds) {
  const long whole = std::lround(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

// Empty as long as too little is done to tell.
std::string TimeLeft(double seconds, double fraction) {
  constexpr double kEnough = 0.02;
  if (fraction < kEnough) return "";
  return fmt::format(", {} left", Minutes(seconds * (1.0 - fraction) / fraction));
}

// The stage names the frames or the window.
std::string Describe(const FitProgress& progress, int recorded_frames) {
  if (!progress.detail.empty()) return progress.detail;
  return fmt::format("iteration {}, cost {:.5g}, error {:.3g} sigma, {:.0f} simulations",
                     progress.iteration, progress.cost, progress.rms,
                     progress.simulated_frames / std::max(1, recorded_frames));
}

std::string Bar(double fraction) {
  const int filled = static_cast<int>(fraction * kBarWidth);
  return "[" + std::string(static_cast<size_t>(filled), '#') +
         std::string(static_cast<size_t>(kBarWidth - filled), '.') + "]";
}

}  // namespace

ProgressDisplay::ProgressDisplay() : is_terminal_(isatty(fileno(Terminal())) != 0) {}

void ProgressDisplay::Show(const FitProgress& progress, int recorded_frames) {
  Show(progress.stage, Describe(progress, recorded_frames), progress.fraction);
}

void ProgressDisplay::Show(const std::string& stage, const std::string& state, double fraction) {
  const double done = std::clamp(fraction, 0.0, 1.0);
  const std::string text = fmt::format("{:3.0f} %{}  {}, {}", 100.0 * done,
                                       TimeLeft(SecondsSince(start_), done), stage, state);
  if (is_terminal_) {
    const size_t width = TerminalWidth() - 1;
    std::string line = Bar(done) + " " + text;
    if (line.size() > width) line = text;  // numbers say more than a bar
    if (line.size() > width) line.resize(width);
    std::fprintf(Terminal(), "\r\x1b[K%s", line.c_str());  // erase to the end of the line
    std::fflush(Terminal());
    has_bar_ = true;
    return;
  }
  const std::string line = text + "\n";
  if (stage == stage_ && SecondsSince(last_) < kPlainInterval) {
    unshown_ = line;
    return;
  }
  stage_ = stage;
  last_ = Clock::now();
  unshown_.clear();
  std::fputs(line.c_str(), Terminal());
}

void ProgressDisplay::Finish() {
  if (has_bar_) std::fputc('\n', Terminal());
  std::fputs(unshown_.c_str(), Terminal());
  has_bar_ = false;
  unshown_.clear();
}

double ProgressDisplay::SecondsSince(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

}  // namespace clothfit
