// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/checked_factor.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Eigen::MatrixXd Symmetric(double diagonal, double beside) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Constant(3, 3, beside);
  matrix.diagonal().setConstant(diagonal);
  return matrix;
}

TEST(Cholesky, SolvesWhatIsPositiveDefinite) {
  const Eigen::MatrixXd matrix = Symmetric(2.0, 0.5);
  const Eigen::Vector3d right(1.0, 2.0, 3.0);
  EXPECT_LT((matrix * Cholesky(matrix, "it").solve(right) - right).norm(), 1e-14);
  EXPECT_TRUE(TryCholesky(Eigen::Matrix3d(matrix)));
  EXPECT_TRUE(TryCholesky(Eigen::MatrixXd(0, 0)));
}

TEST(Cholesky, IsNoneOfWhatIsNot) {
  EXPECT_FALSE(TryCholesky(Symmetric(1.0, 2.0)));
  EXPECT_FALSE(TryCholesky(Symmetric(1.0, 1.0)));
  EXPECT_FALSE(TryCholesky(Symmetric(0.0, 0.0)));
  EXPECT_FALSE(TryCholesky(Symmetric(kNan, 0.0)));
  EXPECT_FALSE(TryCholesky(Symmetric(1.0, kNan)));
  EXPECT_FALSE(TryCholesky(Symmetric(std::numeric_limits<double>::infinity(), 0.0)));
  try {
    Cholesky(Symmetric(1.0, 2.0), "the prior");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the prior cannot be factored: not positive definite");
  }
}

// Columns that hang together, as those of an obstacle that is touched at one place.
TEST(TrySemidefinite, FactorsWhatIsSingularButForRounding) {
  for (int seed = 0; seed < 200; ++seed) {
    std::srand(seed);
    const int rank = 1 + seed % 7;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Random(20, rank) * Eigen::MatrixXd::Random(rank, 12);
    rows.array().rowwise() *= Eigen::ArrayXd::LinSpaced(12, -4.0, 4.0).exp().transpose();
    const Eigen::MatrixXd gram = rows.transpose() * rows;
    const auto factor = TrySemidefinite(gram);
    ASSERT_TRUE(factor) << "seed " << seed;
    EXPECT_LT((factor->reconstructedMatrix() - gram).norm(), 1e-12 * gram.norm());
  }
}

TEST(TrySemidefinite, AllowsNothingBelowRounding) {
  EXPECT_TRUE(TrySemidefinite(Symmetric(2.0, 0.5)));
  EXPECT_TRUE(TrySemidefinite(Symmetric(1.0, 1.0)));
  EXPECT_TRUE(TrySemidefinite(Symmetric(0.0, 0.0)));
  EXPECT_TRUE(TrySemidefinite(Eigen::MatrixXd(0, 0)));
  EXPECT_FALSE(TrySemidefinite(Symmetric(1.0, 2.0)));
  EXPECT_FALSE(TrySemidefinite(Symmetric(-1.0, 0.0)));
  EXPECT_FALSE(TrySemidefinite(Symmetric(kNan, 0.0)));
  EXPECT_FALSE(TrySemidefinite(Symmetric(1.0, kNan)));
}

}  // namespace
}  // namespace clothfit
