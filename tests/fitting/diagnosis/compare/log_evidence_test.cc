// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/log_evidence.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// The marginal likelihood of a mean with a prior of unit information can be written down.
TEST(LogEvidence, IsThatOfAMeanWhosePriorIsWorthOneObservation) {
  constexpr int kRows = 400;
  for (const double mean : {0.0, 0.1, 0.3}) {
    // Observations of unit noise whose own mean is `mean`, and whose squares about it sum to kRows.
    const double before = 0.5 * kRows * (1.0 + mean * mean), after = 0.5 * kRows;
    // N(mean; 0, 1 + 1/n) against N(mean; 0, 1/n).
    const double exact =
        -0.5 * std::log(1.0 + kRows) + 0.5 * mean * mean * kRows * (1.0 - 1.0 / (1.0 + kRows));
    EXPECT_NEAR(LogEvidence(before, after, 1.0, {kRows, 1.0, 1.0}), exact, 0.1) << mean;
  }
}

TEST(LogEvidence, OfResidualsThatHangTogetherIsThatOfFewer) {
  const double of_few = LogEvidence(130.0, 100.0, 3.0, {200.0, 1.0, 1.0});
  EXPECT_DOUBLE_EQ(LogEvidence(1300.0, 1000.0, 3.0, {2000.0, 10.0, 1.0}), of_few);
}

TEST(LogEvidence, ScalesResidualsByWhatIsLeftBeyondNoise) {
  const ResidualScale noise{1000.0, 1.0, 1.0}, more{1000.0, 1.0, 4.0}, less{1000.0, 1.0, 0.5};
  const double penalty = LogEvidence(100.0, 100.0, 2.0, noise);
  EXPECT_LT(penalty, 0.0);
  EXPECT_DOUBLE_EQ(LogEvidence(140.0, 100.0, 2.0, more) - penalty, 10.0);
  EXPECT_DOUBLE_EQ(LogEvidence(140.0, 100.0, 2.0, less) - penalty, 40.0);
}

// A parameter that does nothing, fitted to noise: strong evidence for it is an error.
TEST(LogEvidence, IsHardlyEverStrongForNothing) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  int strong = 0;
  constexpr int kTrials = 4000;
  for (int k = 0; k < kTrials; ++k) {
    const double gain = 0.5 * std::pow(normal(random), 2);  // of one unknown
    strong += LogEvidence(500.0 + gain, 500.0, 1.0, {1000.0, 1.0, 1.0}) >= kStrongEvidence ? 1 : 0;
  }
  EXPECT_LT(strong, 4);
}

}  // namespace
}  // namespace clothfit
