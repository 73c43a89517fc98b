// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/correlation_time.h"

#include <algorithm>

namespace clothfit {

double CorrelationTime(const std::vector<std::vector<double>>& series) {
  constexpr double kNoMore = 0.05;
  std::size_t longest = 0;
  for (const std::vector<double>& values : series) longest = std::max(longest, values.size());
  const auto pooled = [&](std::size_t lag) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const std::vector<double>& values : series) {
      for (std::size_t i = 0; i + lag < values.size(); ++i, ++count)
        sum += values[i] * values[i + lag];
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  };
  const double variance = pooled(0);
  double time = 1.0;
  for (std::size_t lag = 1; variance > 0.0 && 2 * lag < longest; ++lag) {
    const double correlation = pooled(lag) / variance;
    if (correlation < kNoMore) break;
    time += 2.0 * correlation;
  }
  return time;
}

}  // namespace clothfit
