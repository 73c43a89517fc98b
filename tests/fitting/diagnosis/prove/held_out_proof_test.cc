// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/prove/held_out_proof.h"

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

TEST(HeldOutProof, AClearImprovementIsProven) {
  const HeldOutProof proof =
      Prove(Errors(0.030, 0.1, 1), Errors(0.009, 0.1, 2), 6, {0.008, 0.0}, 1);
  EXPECT_TRUE(proof.is_proven);
  EXPECT_NEAR(proof.before - proof.after, 0.021, 0.002);
  EXPECT_LT(proof.improvement_lower95, proof.before - proof.after);
  EXPECT_GT(proof.improvement_lower95, 0.015);
}

TEST(HeldOutProof, ChanceIsNoProof) {
  int proven = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    proven +=
        Prove(Errors(0.01, 0.5, 2 * seed), Errors(0.01, 0.5, 2 * seed + 1), 1, {}, 1).is_proven;
  }
  EXPECT_LE(proven, 6);  // 2 are expected of a test at 95 %
}

TEST(HeldOutProof, AnImprovementFarBelowTheFloorIsNoProof) {
  const HeldOutErrors before = Errors(0.0101, {}, 1), after = Errors(0.0100, 0.0, 1);
  EXPECT_TRUE(Prove(before, after, 6, {}, 1).is_proven);
  EXPECT_FALSE(Prove(before, after, 6, {0.01, 0.0}, 1).is_proven);
}

TEST(HeldOutProof, AnImprovementBelowTheNumericalFloorIsNoProof) {
  const HeldOutErrors before = Errors(0.010, 0.0, 1),
                      after = Errors(0.008, 0.0, 1);  // 6 mm squared
  EXPECT_TRUE(Prove(before, after, 6, {0.002, 0.005}, 1).is_proven);
  EXPECT_FALSE(Prove(before, after, 6, {0.002, 0.007}, 1).is_proven);
}

TEST(HeldOutProof, ASimulationThatDoesNotGetThereProvesNothing) {
  HeldOutErrors after = Errors(0.001, {}, 1);
  after.is_complete = false;
  EXPECT_FALSE(Prove(Errors(0.03, 0.0, 1), after, 6, {}, 1).is_proven);
}

}  // namespace
}  // namespace clothfit
