// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Additive conservative advancement: time goes on in steps, each of which is known to leave a part
// of the gap, until little of the gap is left. It never steps over a contact, whatever the motion.
// Li, Kaufman and Jiang 2021, "Codimensional incremental potential contact", sec. 5.
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>

namespace clothfit {

// When two things count as having met: when their gap, which is their distance minus the
// separation, is at most the tolerance and at most the slack's share of what it was at time 0.
struct Approach {
  double separation = 0.0;  // m, 0 or more
  double tolerance = 1e-4;  // m, above 0; smaller finds the time more closely, with more steps
  double slack = 0.1;       // in [1e-6, 1), so that a pair that is close already may come closer
};

// The first time in [0, until] at which `pair` has met, or none. Before that time and at it the gap
// is above 0, so that a step that ends there is safe. It is 0 where there is no gap at time 0
// already.
//   pair.Distance(t)        m, at time t; it may be too small, but not too large
//   pair.SafeStep(target)   a step from the last t in which the distance stays above target (m),
//                           where it is above it at t; may be infinite
//   pair.rounding()         m, below which a gap is not to be trusted: twice the error of a step
template <class Pair>
std::optional<double> Advance(const Approach& approach, double until, Pair* pair) {
  assert(approach.separation >= 0.0 && approach.tolerance > 0.0);
  assert(approach.slack >= 1e-6 && approach.slack < 1.0);
  constexpr int kMaxSteps = 10000;  // then the time reached is given, which is early
  double time = 0.0;
  double gap = pair->Distance(0.0) - approach.separation;
  if (gap <= pair->rounding()) return 0.0;
  const double met = std::min(approach.tolerance, approach.slack * gap);
  for (int step = 0; step < kMaxSteps; ++step) {
    const double left = std::max(approach.slack * gap, 0.5 * pair->rounding());
    const double next = time + pair->SafeStep(approach.separation + left);
    if (next > until) return std::nullopt;
    const double next_gap = pair->Distance(next) - approach.separation;
    if (next_gap <= pair->rounding()) return time;
    time = next;
    gap = next_gap;
    if (gap <= met) return time;
  }
  return time;
}

}  // namespace clothfit
