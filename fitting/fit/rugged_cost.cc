// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/rugged_cost.h"

#include <fmt/format.h>

#include "fitting/config/config.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr const char* kBegin = "the fit came to rest where a full step promises ";

}  // namespace

std::string SayCostIsRugged(double promised, double window) {
  const double shorter = window > 0.0 ? 0.5 * window : FitConfig().window;
  return fmt::format(
      "{}{:.0f} % less cost: the cost is rugged here; shorter windows (--window {:.2g}) or another "
      "start may get past it, --resume does not",
      kBegin, 100.0 * promised, shorter);
}

std::string RuggedCostAmong(const std::vector<std::string>& statements) {
  for (const std::string& statement : statements)
    if (StartsWith(statement, kBegin)) return statement;
  return "";
}

}  // namespace clothfit
