// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a long work is, on the standard error: a bar on a terminal, else a plain line now and
// then.
#pragma once

#include <chrono>
#include <string>

#include "fitting/fit/fit.h"

namespace clothfit {

class ProgressDisplay {
 public:
  ProgressDisplay();
  // Stage with its frames, cost, error, simulations of the whole recording, time left.
  void Show(const FitProgress& progress, int recorded_frames);
  // `fraction` of the whole is done; plain lines of one stage come at intervals.
  void Show(const std::string& stage, const std::string& state, double fraction);
  // Shows where it ended and leaves the bar's line; nothing is shown afterwards.
  void Finish();

 private:
  using Clock = std::chrono::steady_clock;
  static double SecondsSince(Clock::time_point time);

  bool is_terminal_;
  bool has_bar_ = false;  // the cursor stands at the end of a bar
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::string stage_, unshown_;  // of the last plain line; the line passed over since
};

}  // namespace clothfit
