// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/wind_problem.h"

namespace clothfit {
namespace {

TEST(Wind, IsFoundUpToTheGaugeOfMassAndForces) {
  WindProblem problem;
  problem.particles = 9;
  problem.steps = 70;
  const WindRecovery recovery = RecoverWind(problem);
  EXPECT_TRUE(recovery.converged);
  EXPECT_LE(recovery.iterations, 10);
  EXPECT_LT(recovery.rms_after, 1e-3 * recovery.rms_before);
  for (const char* name : {"wind.frequency", "wind.phase", "wind.azimuth", "wind.elevation"}) {
    const WindUnknown& unknown = recovery.Find(name);
    EXPECT_NEAR(unknown.found / unknown.truth, 1.0, 1e-3) << name;
  }
  // Every force and the mass times one factor move the cloth alike.
  const WindUnknown& density = recovery.Find("cloth.areal_density");
  for (const char* name : {"stretch.stiffness", "bending.stiffness", "wind.strength"}) {
    const WindUnknown& unknown = recovery.Find(name);
    EXPECT_NEAR(unknown.found / unknown.truth / (density.found / density.truth), 1.0, 1e-2) << name;
  }
  ASSERT_EQ(recovery.statements.size(), 1u);
  EXPECT_THAT(recovery.statements.front(), testing::AllOf(testing::HasSubstr("only the ratios of"),
                                                          testing::HasSubstr("stretch.stiffness"),
                                                          testing::HasSubstr("bending.stiffness"),
                                                          testing::HasSubstr("cloth.areal_density"),
                                                          testing::HasSubstr("wind.strength")));
}

}  // namespace
}  // namespace clothfit
