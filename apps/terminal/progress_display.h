// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a long work is, on the standard error: a bar on a terminal, else a plain line now and
// then. What is done never goes back, and is not all before the end.
#pragma once

#include <chrono>
#include <string>

#include "fitting/fit/fit.h"

namespace clothfit {

// "[####....] 42 %, 1:10 left"; without the time where too little or nearly all is done, when it
// would be a guess. `fraction` is clamped to 0 .. 0.99.
std::string ProgressText(double fraction, double seconds, bool with_bar);

class ProgressDisplay {
 public:
  // Plain lines come with each new stage, or now and then whatever the stage; then short work shows
  // nothing.
  enum class Lines { kEachStage, kNowAndThen };
  explicit ProgressDisplay(Lines lines = Lines::kEachStage);
  // Stage with its frames, cost, error, simulations of the whole recording, time left.
  void Show(const FitProgress& progress, int recorded_frames);
  // `fraction` of the whole is done; plain lines of one stage come at intervals.
  void Show(const std::string& stage, const std::string& state, double fraction);
  // A line that stays, above what is shown afterwards.
  void Note(const std::string& line);
  // Shows where it ended and leaves the bar's line; nothing is shown afterwards.
  void Finish();

 private:
  using Clock = std::chrono::steady_clock;
  static double SecondsSince(Clock::time_point time);
  void ShowOnTerminal(const std::string& text);
  void ShowLine(const std::string& stage, const std::string& text);

  bool is_terminal_;
  Lines lines_;
  bool has_bar_ = false;  // the cursor stands at the end of a bar
  double done_ = 0.0;     // the most that was shown
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::string stage_, unshown_;  // of the last plain line; the line passed over since
};

}  // namespace clothfit
