// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The score test against plain least squares, where both are exact.
#include "fitting/diagnosis/evidence/rao_score.h"

#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

Eigen::MatrixXd RandomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// Columns: 0 the residual, 1-3 nuisances, 4-5 and 6 two groups.
struct Problem {
  Eigen::MatrixXd columns = RandomMatrix(60, 7, 7);
  Eigen::MatrixXd gram = columns.transpose() * columns;
  std::vector<Nuisance> free = {{1, 0.0}, {2, 0.0}, {3, 0.0}};
};

double LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::VectorXd* x) {
  *x = a.colPivHouseholderQr().solve(b);
  return (b - a * *x).squaredNorm();
}

TEST(ScoreTest, IsTheDecreaseOfALeastSquaresFit) {
  const Problem p;
  const Projection projection(p.gram, p.free);
  const ScoredGroup group{{4, 5}, {false, false}, {}};
  const Score score = ScoreOf(projection, group, projection.gram().col(0));
  Eigen::VectorXd x;
  const double without = LeastSquares(p.columns.middleCols(1, 3), p.columns.col(0), &x);
  const double with = LeastSquares(p.columns.middleCols(1, 5), p.columns.col(0), &x);
  EXPECT_NEAR(score.decrease, without - with, 1e-9);
  // A model with these amounts has the residual r + S a: they cancel what least squares finds.
  EXPECT_NEAR(score.amounts[0], -x[3], 1e-9);
  EXPECT_NEAR(score.amounts[1], -x[4], 1e-9);
}

TEST(ScoreTest, SigmaIsThatOfLeastSquares) {
  const Problem p;
  const Projection projection(p.gram, p.free);
  const Score score = ScoreOf(projection, {{4, 5}, {false, false}, {}}, projection.gram().col(0));
  const Eigen::MatrixXd a = p.columns.middleCols(1, 5);
  const Eigen::MatrixXd covariance = (a.transpose() * a).inverse();
  EXPECT_NEAR(score.sigma[0], std::sqrt(covariance(3, 3)), 1e-9);
  EXPECT_NEAR(score.sigma[1], std::sqrt(covariance(4, 4)), 1e-9);
}

TEST(ScoreTest, ANuisanceOfKnownSizeIsRidgeRegression) {
  const Problem p;
  const double precision = 25.0;
  const Projection projection(p.gram, {{1, precision}});
  Eigen::MatrixXd a(61, 1), with(61, 2);
  a << p.columns.col(1), std::sqrt(precision);
  with << a, (Eigen::VectorXd(61) << p.columns.col(6), 0.0).finished();
  const Eigen::VectorXd b = (Eigen::VectorXd(61) << p.columns.col(0), 0.0).finished();
  Eigen::VectorXd x;
  const double decrease = LeastSquares(a, b, &x) - LeastSquares(with, b, &x);
  const Score score = ScoreOf(projection, {{6}, {false}, {}}, projection.gram().col(0));
  EXPECT_NEAR(score.decrease, decrease, 1e-9);
  EXPECT_NEAR(score.amounts[0], -x[1], 1e-9);
}

TEST(ScoreTest, AmountsThatAreImpossibleAreLeftOut) {
  Problem p;
  const Projection projection(p.gram, p.free);
  const Score free = ScoreOf(projection, {{6}, {false}, {}}, projection.gram().col(0));
  const Score bounded = ScoreOf(projection, {{6}, {true}, {}}, projection.gram().col(0));
  // With the residual turned round, what was impossible is possible.
  const Score turned = ScoreOf(projection, {{6}, {true}, {}}, -projection.gram().col(0));
  ASSERT_NE(free.amounts[0], 0.0);
  const Score& possible = free.amounts[0] > 0.0 ? bounded : turned;
  const Score& impossible = free.amounts[0] > 0.0 ? turned : bounded;
  EXPECT_NEAR(possible.decrease, free.decrease, 1e-9);
  EXPECT_EQ(impossible.decrease, 0.0);
  EXPECT_EQ(impossible.amounts[0], 0.0);
}

TEST(ScoreTest, OfManyResidualsIsThatOfEach) {
  const Problem p;
  const Projection projection(p.gram, p.free);
  const ScoredGroup group{{4, 5, 6}, {false, true, true}, {0.5}};
  const Scorer scorer(projection, group);
  int num_left_out = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Eigen::VectorXd products = RandomMatrix(7, 1, seed);
    const Score many = scorer.Of(products), one = ScoreOf(projection, group, products);
    EXPECT_DOUBLE_EQ(many.decrease, one.decrease);
    EXPECT_EQ(many.amounts, one.amounts);
    EXPECT_GE(many.amounts.tail<2>().minCoeff(), 0.0);
    num_left_out += many.amounts.tail<2>().minCoeff() == 0.0 ? 1 : 0;
    // Where none is left out, the sum of squares is that of ridge regression.
    if (many.amounts.tail<2>().minCoeff() == 0.0) continue;
    Eigen::MatrixXd information = projection.gram().block<3, 3>(4, 4);
    information(0, 0) += 0.5;
    const Eigen::VectorXd solution = information.ldlt().solve(products.segment<3>(4));
    EXPECT_NEAR(many.decrease, solution.dot(products.segment<3>(4)), 1e-9);
  }
  EXPECT_GT(num_left_out, 0);
  EXPECT_LT(num_left_out, 20);
}

TEST(ScoreTest, WhatNuisancesCanDoIsNotScored) {
  Problem p;
  p.columns.col(6) = p.columns.col(1) - 2.0 * p.columns.col(3);
  p.gram = p.columns.transpose() * p.columns;
  const Projection projection(p.gram, p.free);
  const Score score = ScoreOf(projection, {{6}, {false}, {}}, projection.gram().col(0));
  EXPECT_LT(score.decrease, 1e-6 * p.gram(0, 0));
}

TEST(ScoreTest, EqualSignaturesHaveCosineOne) {
  Problem p;
  p.columns.col(6) = 3.0 * p.columns.col(4) + p.columns.col(2);  // the same after projection
  p.gram = p.columns.transpose() * p.columns;
  const Projection projection(p.gram, p.free);
  EXPECT_NEAR(LargestCosine(projection, {4}, {6}), 1.0, 1e-9);
  EXPECT_LT(LargestCosine(projection, {5}, {6}), 0.9);
}

TEST(ScoreTest, TailFollowsChiSquared) {
  // Draws of a chi-squared of three degrees of freedom, whose tail is known.
  std::mt19937 random(3);
  std::chi_squared_distribution<double> chi2(3.0);
  std::vector<double> draws;
  for (int k = 0; k < 4000; ++k) draws.push_back(chi2(random));
  EXPECT_NEAR(TailProbability(draws, 7.815), 0.05, 0.01);
  const double far = TailProbability(draws, 27.9);  // 3.8e-6, beyond all draws
  EXPECT_GT(far, 3.8e-7);
  EXPECT_LT(far, 3.8e-5);
}

TEST(ScoreTest, FalseDiscoveryRatesAreThoseOfBenjaminiAndHochberg) {
  // Sorted: 0.01 * 4 / 1, 0.02 * 4 / 2, 0.03 * 4 / 3, 0.5 * 4 / 4, made monotone.
  const std::vector<double> rates = FalseDiscoveryRates({0.5, 0.01, 0.03, 0.02});
  EXPECT_NEAR(rates[0], 0.5, 1e-12);
  EXPECT_NEAR(rates[1], 0.04, 1e-12);
  EXPECT_NEAR(rates[2], 0.04, 1e-12);
  EXPECT_NEAR(rates[3], 0.04, 1e-12);
}

}  // namespace
}  // namespace clothfit
