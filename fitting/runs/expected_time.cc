// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/expected_time.h"

#include <cmath>

#include <fmt/format.h>

namespace clothfit {

std::string ExpectedTime::Tell(double fraction, double seconds) {
  constexpr double kLeast = 0.02;               // as ProgressText has it
  constexpr double kShort = 1.0, kLong = 10.0;  // min
  if (is_told_ || !(fraction >= kLeast)) return "";
  is_told_ = true;
  const double minutes = seconds / std::fmin(fraction, 1.0) / 60.0;
  if (minutes < kShort) return "";
  const std::string line = fmt::format("takes about {:.0f} minutes in all", minutes);
  if (minutes < kLong) return line;
  return line +
         "; fewer frames (--frames A B, or clothfit import markers --every N) or particles "
         "(--resolution NU NV) take less";
}

}  // namespace clothfit
