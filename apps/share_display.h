// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of some work is done, on the standard error: one line that changes on a terminal, else a
// line now and then. Short work shows nothing.
#pragma once

#include <chrono>
#include <string>

namespace clothfit {

class ShareDisplay {
 public:
  ShareDisplay();
  // The share of a stage that is done, 0 to 1.
  void Show(double share, const std::string& stage);
  // Ends the line; nothing is shown afterwards.
  void Finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_terminal_;
  bool has_line_ = false;  // the cursor stands at the end of one
  Clock::time_point last_ = Clock::now();
};

}  // namespace clothfit
