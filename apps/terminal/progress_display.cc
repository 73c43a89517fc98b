// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/terminal/progress_display.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/printable.h"

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

std::string ProgressText(double fraction, double seconds, bool with_bar) {
  constexpr double kLeast = 0.02, kMost = 0.99;
  const double done = std::clamp(fraction, 0.0, kMost);
  std::string text = with_bar ? Bar(done) + " " : "";
  text += fmt::format("{:3.0f} %", std::floor(100.0 * done + 1e-9));
  if (done < kLeast || done >= kMost) return text;
  return text + fmt::format(", {} left", Minutes(seconds * (1.0 - done) / done));
}

ProgressDisplay::ProgressDisplay(Lines lines)
    : is_terminal_(isatty(fileno(Terminal())) != 0), lines_(lines) {}

void ProgressDisplay::Show(const FitProgress& progress, int recorded_frames) {
  Show(progress.stage, Describe(progress, recorded_frames), progress.fraction);
}

void ProgressDisplay::Show(const std::string& stage, const std::string& state, double fraction) {
  done_ = std::max(done_, std::isfinite(fraction) ? fraction : 0.0);
  const std::string rest = "  " + Printable(stage + (state.empty() ? "" : ", " + state));
  const double seconds = SecondsSince(start_);
  const std::string text = ProgressText(done_, seconds, false) + rest;
  if (!is_terminal_) return ShowLine(stage, text + "\n");
  const std::string with_bar = ProgressText(done_, seconds, true) + rest;
  ShowOnTerminal(with_bar.size() < TerminalWidth() ? with_bar : text);  // numbers say more
}

void ProgressDisplay::ShowOnTerminal(const std::string& text) {
  constexpr double kInterval = 0.1;  // s; more often than one reads is work for nothing
  if (lines_ == Lines::kNowAndThen && SecondsSince(last_) < kInterval) return;
  last_ = Clock::now();
  std::fprintf(Terminal(), "\r\x1b[K%s", text.substr(0, TerminalWidth() - 1).c_str());
  std::fflush(Terminal());
  has_bar_ = true;
}

void ProgressDisplay::ShowLine(const std::string& stage, const std::string& line) {
  const bool is_new = lines_ == Lines::kEachStage && stage != stage_;
  if (!is_new && SecondsSince(last_) < kPlainInterval) {
    if (lines_ == Lines::kEachStage) unshown_ = line;
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

void ProgressDisplay::Note(const std::string& line) {
  if (has_bar_) std::fputs("\r\x1b[K", Terminal());
  has_bar_ = false;
  std::fputs((Printable(line) + "\n").c_str(), Terminal());
}

double ProgressDisplay::SecondsSince(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

}  // namespace clothfit
