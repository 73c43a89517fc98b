// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/parameter_intervals.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(ParameterIntervals, AreThoseOfTheFitAt90PercentWithinItsBounds) {
  FitResult fit;
  fit.estimates = {{"stretch.stiffness", "N/m", 700.0, 1000.0, true, 690.0, 710.0},
                   {"wind.x", "m/s", 1.0, 0.0, true, 0.02, 1.98},
                   {"hem.low_u", "kg/m", 0.01, 0.0, true, -0.02, 0.2}};
  FitConfig config;
  for (const ParameterEstimate& estimate : fit.estimates) {
    config.parameters[estimate.name].lower = 0.0;
    config.parameters[estimate.name].upper = 100.0;
  }
  config.parameters["hem.low_u"].upper = 0.1;
  const std::vector<EffectParameter> parameters = EstimatesOf(fit, config, {"hem.low_u", "wind.x"});
  ASSERT_EQ(parameters.size(), 2u);
  EXPECT_EQ(parameters[0].name, "wind.x");
  EXPECT_EQ(parameters[0].unit, "m/s");
  EXPECT_EQ(parameters[0].value, 1.0);
  EXPECT_NEAR(parameters[0].lower90, 1.0 - 0.5 * 1.645, 1e-9);
  EXPECT_NEAR(parameters[0].upper90, 1.0 + 0.5 * 1.645, 1e-9);
  EXPECT_EQ(parameters[1].lower90, 0.0);
  EXPECT_EQ(parameters[1].upper90, 0.1);
}

TEST(ParameterIntervals, AreNotThereOfWhatIsHeld) {
  FitResult fit;
  fit.estimates = {{"obstacle_capsule.y1", "m", 0.4, 0.4, false, 0.4, 0.4}};
  FitConfig config;
  config.parameters["obstacle_capsule.y1"].lower = -10.0;
  config.parameters["obstacle_capsule.y1"].upper = 10.0;
  const std::vector<EffectParameter> parameters = EstimatesOf(fit, config, {"obstacle_capsule.y1"});
  ASSERT_EQ(parameters.size(), 1u);
  EXPECT_EQ(parameters[0].value, 0.4);
  EXPECT_TRUE(std::isnan(parameters[0].lower90));
  EXPECT_TRUE(std::isnan(parameters[0].upper90));
}

}  // namespace
}  // namespace clothfit
