// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// When a minimisation ends.
#include "fitting/optimise/levenberg_marquardt.h"

#include <vector>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

struct Step {
  double change;  // of a cost of 100
  double radius;
  bool is_taken = true;
};

// The iteration that a descent ends with; 0 where it goes on.
int EndOf(const std::vector<Step>& steps) {
  EndOfDescent end(1e-3, 1.0, 3);
  ceres::IterationSummary iteration;
  iteration.iteration = 0;
  iteration.step_is_successful = true;
  iteration.cost = 100.0;
  iteration.trust_region_radius = 10.0;
  EXPECT_FALSE(end.IsReached(iteration)) << "where it begins";
  for (const Step& step : steps) {
    ++iteration.iteration;
    iteration.cost_change = step.change;
    iteration.trust_region_radius = step.radius;
    iteration.step_is_successful = step.is_taken;
    if (end.IsReached(iteration)) return iteration.iteration;
  }
  return 0;
}

TEST(EndOfDescent, IsAFreeStepThatGainsLittle) {
  EXPECT_EQ(EndOf({{5.0, 3.0}, {0.2, 3.0}, {0.05, 3.0}, {0.05, 3.0}}), 3);
}

TEST(EndOfDescent, IsNoStepThatWasNotTaken) {
  EXPECT_EQ(EndOf({{5.0, 3.0}, {0.0, 1.5, false}, {0.0, 1.0, false}}), 0);
}

TEST(EndOfDescent, IsNoSmallStepOfASmallTrustRegion) {
  EXPECT_EQ(EndOf({{0.05, 0.1}, {0.05, 0.3}}), 0);
  EXPECT_EQ(EndOf({{0.05, 0.1}, {0.05, 0.3}, {3.0, 0.9}, {0.05, 0.9}, {0.05, 0.9}}), 0);
}

TEST(EndOfDescent, IsThreeSmallStepsInTurnOfAnyTrustRegion) {
  EXPECT_EQ(EndOf({{0.05, 0.1}, {0.05, 0.1}, {0.05, 0.1}}), 3);
  EXPECT_EQ(EndOf({{0.05, 0.1}, {0.0, 0.05, false}, {0.05, 0.1}, {0.05, 0.1}}), 4);
}

}  // namespace
}  // namespace clothfit
