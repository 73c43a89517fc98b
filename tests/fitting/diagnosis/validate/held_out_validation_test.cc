// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/validate/held_out_validation.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

HeldOutErrors Errors(double rms, double spread, unsigned seed, int frames = 60) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  HeldOutErrors errors;
  errors.is_complete = true;
  for (int k = 0; k < frames; ++k)
    errors.squared.push_back(std::pow(rms * std::exp(spread * normal(random)), 2));
  return errors;
}

TEST(HeldOutValidation, AClearImprovementIsValidated) {
  const HeldOutValidation validation =
      Validate(Errors(0.030, 0.1, 1), Errors(0.009, 0.1, 2), 6, {0.008, 0.0}, 1);
  EXPECT_TRUE(validation.is_validated);
  EXPECT_NEAR(validation.before - validation.after, 0.021, 0.002);
  EXPECT_LT(validation.improvement_lower95, validation.before - validation.after);
  EXPECT_GT(validation.improvement_lower95, 0.015);
}

TEST(HeldOutValidation, ChanceIsNoValidation) {
  int validated = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    validated += Validate(Errors(0.01, 0.5, 2 * seed), Errors(0.01, 0.5, 2 * seed + 1), 1, {}, 1)
                     .is_validated;
  }
  EXPECT_LE(validated, 6);  // 2 are expected of a test at 95 %
}

TEST(HeldOutValidation, AnImprovementFarBelowTheNoiseIsNoValidation) {
  const HeldOutErrors before = Errors(0.0101, {}, 1), after = Errors(0.0100, 0.0, 1);
  EXPECT_TRUE(Validate(before, after, 6, {}, 1).is_validated);
  EXPECT_FALSE(Validate(before, after, 6, {0.01, 0.0}, 1).is_validated);
}

TEST(HeldOutValidation, AnImprovementBelowTheDiscretisationErrorIsNoValidation) {
  const HeldOutErrors before = Errors(0.010, 0.0, 1),
                      after = Errors(0.008, 0.0, 1);  // 6 mm squared
  EXPECT_TRUE(Validate(before, after, 6, {0.002, 0.005}, 1).is_validated);
  EXPECT_FALSE(Validate(before, after, 6, {0.002, 0.007}, 1).is_validated);
}

TEST(HeldOutValidation, ASimulationThatDoesNotGetThereValidatesNothing) {
  HeldOutErrors after = Errors(0.001, {}, 1);
  after.is_complete = false;
  EXPECT_FALSE(Validate(Errors(0.03, 0.0, 1), after, 6, {}, 1).is_validated);
}

}  // namespace
}  // namespace clothfit
