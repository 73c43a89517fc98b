// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/profile_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr double kSigmas = 1.959964;

ResponseModel TwoEntries(bool is_log) {
  ResponseModel model;
  model.data_information = (Eigen::Matrix2d() << 4.0, 3.0, 3.0, 5.0).finished();
  model.data_gradient = Eigen::Vector2d(0.3, -0.2);
  model.prior_information = Eigen::Vector2d(0.2, 0.4).asDiagonal();
  model.is_log = {is_log, is_log};
  return model;
}

Eigen::MatrixXd Covariance(const ResponseModel& model) {
  return (model.data_information + model.prior_information).inverse();
}

// Twice the growth of the cost, written another way.
double Growth(const ResponseModel& model, double d0, double d1) {
  const Eigen::Vector2d d(d0, d1);
  Eigen::Vector2d s = d;
  for (int i = 0; i < 2; ++i) {
    if (model.is_log[static_cast<std::size_t>(i)] && d[i] < 0.0) s[i] = std::exp(d[i]) - 1.0;
  }
  return (s.transpose() * model.data_information * s)(0) + 2.0 * model.data_gradient.dot(s - d) +
         (d.transpose() * model.prior_information * d)(0);
}

// The least over the second entry, by brute force.
double LeastGrowth(const ResponseModel& model, double d0) {
  double least = std::numeric_limits<double>::infinity();
  for (double d1 = -12.0; d1 < 12.0; d1 += 1e-4) least = std::min(least, Growth(model, d0, d1));
  return least;
}

TEST(ProfileInterval, IsTheCovariancesOnLinearScales) {
  const ResponseModel model = TwoEntries(false);
  const Eigen::MatrixXd covariance = Covariance(model);
  for (int i = 0; i < 2; ++i) {
    const Interval interval = ProfileInterval(model, covariance, i, kSigmas);
    const double width = kSigmas * std::sqrt(covariance(i, i));
    EXPECT_NEAR(interval.upper, width, 1e-3 * width);  // the search stops at a thousandth
    EXPECT_NEAR(interval.lower, -width, 1e-3 * width);
  }
}

TEST(ProfileInterval, EndsWhereTheLeastCostHasGrownByTheSigmas) {
  const ResponseModel model = TwoEntries(true);
  const Interval interval = ProfileInterval(model, Covariance(model), 0, kSigmas);
  // The growth is quadratic or so in the offset, which is found to a thousandth.
  EXPECT_NEAR(LeastGrowth(model, interval.upper), kSigmas * kSigmas, 4e-3 * kSigmas * kSigmas);
  EXPECT_NEAR(LeastGrowth(model, interval.lower), kSigmas * kSigmas, 4e-3 * kSigmas * kSigmas);
  // Correlated with an entry that the data cannot keep from zero, the lower end moves outwards.
  const double width = kSigmas * std::sqrt(Covariance(model)(0, 0));
  EXPECT_LT(interval.lower, -width);
}

TEST(ProfileInterval, IsNarrowAndSymmetricWhereTheDataTellMuch) {
  ResponseModel model = TwoEntries(true);
  model.data_information *= 1e6;
  const Eigen::MatrixXd covariance = Covariance(model);
  const Interval interval = ProfileInterval(model, covariance, 1, kSigmas);
  const double width = kSigmas * std::sqrt(covariance(1, 1));
  EXPECT_NEAR(interval.upper, width, 3e-3 * width);
  EXPECT_NEAR(interval.lower, -width, 3e-3 * width);
}

TEST(ProfileInterval, ReachesDownToThePriorWhereTheDataCannotTellFromZero) {
  ResponseModel model;
  model.data_information = Eigen::MatrixXd::Constant(1, 1, 2.0);  // zero is 1.4 sigmas away
  model.data_gradient = Eigen::VectorXd::Zero(1);
  const double prior_sigma = std::log(10.0);
  model.prior_information = Eigen::MatrixXd::Constant(1, 1, 1.0 / (prior_sigma * prior_sigma));
  model.is_log = {true};
  const Interval interval = ProfileInterval(model, Covariance(model), 0, kSigmas);
  // 2 (1 - exp(d))^2 + (d / prior_sigma)^2 = 3.84, solved by iteration.
  double expected = -prior_sigma;
  for (int i = 0; i < 100; ++i) {
    const double share = 1.0 - std::exp(expected);
    expected = -prior_sigma * std::sqrt(kSigmas * kSigmas - 2.0 * share * share);
  }
  EXPECT_NEAR(interval.lower, expected, 0.01);
}

}  // namespace
}  // namespace clothfit
