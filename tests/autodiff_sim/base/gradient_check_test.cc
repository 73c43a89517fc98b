// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The gradient checker: it must accept right Jacobians, reject wrong ones, and know when it cannot
// tell.
#include "autodiff_sim/base/gradient_check.h"

#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

Eigen::VectorXd Point() {
  Eigen::VectorXd p(2);
  p << 0.7, -1.3;
  return p;
}

bool Smooth(const Eigen::VectorXd& p, Eigen::VectorXd* f) {
  f->resize(2);
  *f << std::sin(3.0 * p[0]) * p[1], std::exp(p[0]) + p[1] * p[1] * p[1];
  return true;
}

Eigen::MatrixXd SmoothJacobian(const Eigen::VectorXd& p) {
  Eigen::MatrixXd j(2, 2);
  j << 3.0 * std::cos(3.0 * p[0]) * p[1], std::sin(3.0 * p[0]), std::exp(p[0]), 3.0 * p[1] * p[1];
  return j;
}

TEST(GradientCheck, AcceptsTheRightJacobianToNearRoundoff) {
  const Eigen::VectorXd p = Point();
  GradientCheckOptions options;
  options.tolerance = 1e-9;  // five extrapolations from 1 % leave about 1e-12
  const GradientCheckReport report = CheckGradient(Smooth, p, SmoothJacobian(p), options);
  ASSERT_EQ(report.columns.size(), 2u);
  EXPECT_EQ(report.Count(GradientVerdict::kAgrees), 2);
  EXPECT_LT(report.WorstRelativeError(), 1e-10);
}

TEST(GradientCheck, RejectsOneWrongEntry) {
  const Eigen::VectorXd p = Point();
  Eigen::MatrixXd j = SmoothJacobian(p);
  j(1, 0) *= 1.0 + 1e-4;
  const GradientCheckReport report = CheckGradient(Smooth, p, j);
  EXPECT_EQ(report.columns[0].verdict, GradientVerdict::kDisagrees);
  EXPECT_EQ(report.columns[1].verdict, GradientVerdict::kAgrees);
  // The error is told relative to the column's largest entry, 1.97; the wrong entry is 2.01.
  EXPECT_NEAR(report.columns[0].relative_error, 1e-4, 1e-5);
}

TEST(GradientCheck, RejectsNotANumber) {
  const Eigen::VectorXd p = Point();
  Eigen::MatrixXd j = SmoothJacobian(p);
  j(0, 1) = std::nan("");
  const GradientCheckReport report = CheckGradient(Smooth, p, j);
  EXPECT_EQ(report.columns[1].verdict, GradientVerdict::kDisagrees);
}

TEST(GradientCheck, CannotDecideOnNoise) {
  // Noise of 1e-4 of f makes differences err by 1e-4 / step, at least 1e-2 of the derivative, far
  // more than the tolerance; the Jacobian is that of f without the noise. The noise is a hash of p.
  const VectorFunction noisy = [](const Eigen::VectorXd& p, Eigen::VectorXd* f) {
    std::mt19937_64 hash(static_cast<std::uint64_t>(std::llround(p[0] * 1e15)));
    const double noise = std::uniform_real_distribution<double>(-1.0, 1.0)(hash);
    *f = Eigen::VectorXd::Constant(1, p[0] + 1e-4 * noise);
    return true;
  };
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(1, 1.0);
  const Eigen::MatrixXd j = Eigen::MatrixXd::Constant(1, 1, 1.0);
  const GradientCheckReport report = CheckGradient(noisy, p, j);
  EXPECT_EQ(report.columns[0].verdict, GradientVerdict::kUndecided);
  EXPECT_GT(report.columns[0].difference_error, 1e-3);
  EXPECT_EQ(report.WorstRelativeError(), 0.0);  // of what was decided
}

TEST(GradientCheck, ShrinksAFirstStepThatIsFarTooLong) {
  const VectorFunction wave = [](const Eigen::VectorXd& p, Eigen::VectorXd* f) {
    f->resize(1);
    (*f)[0] = std::sin(40.0 * p[0]);
    return true;
  };
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(1, 1.0);
  GradientCheckOptions options;
  options.first_step = 0.5;  // three wavelengths
  options.max_steps = 14;
  const Eigen::MatrixXd j = Eigen::MatrixXd::Constant(1, 1, 40.0 * std::cos(40.0));
  const GradientCheckReport report = CheckGradient(wave, p, j, options);
  EXPECT_EQ(report.columns[0].verdict, GradientVerdict::kAgrees);
  EXPECT_LT(report.columns[0].step, 0.05);
}

TEST(GradientCheck, LeavesOutStepsAtWhichNothingCanBeEvaluated) {
  const VectorFunction root = [](const Eigen::VectorXd& p, Eigen::VectorXd* f) {
    if (p[0] < 0.0) return false;
    *f = p.cwiseSqrt();
    return true;
  };
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(1, 0.01);
  GradientCheckOptions options;
  options.typical = Eigen::VectorXd::Constant(1, 4.0);  // first step 0.04, beyond zero
  options.max_steps = 12;
  const Eigen::MatrixXd j = Eigen::MatrixXd::Constant(1, 1, 5.0);
  EXPECT_EQ(CheckGradient(root, p, j, options).columns[0].verdict, GradientVerdict::kAgrees);
  const VectorFunction never = [](const Eigen::VectorXd&, Eigen::VectorXd*) { return false; };
  EXPECT_EQ(CheckGradient(never, p, j, options).columns[0].verdict, GradientVerdict::kUndecided);
}

TEST(GradientCheck, AColumnOfZerosAgreesWithZeros) {
  const VectorFunction constant = [](const Eigen::VectorXd&, Eigen::VectorXd* f) {
    f->setLinSpaced(3, 1.0, 3.0);
    return true;
  };
  const Eigen::VectorXd p = Eigen::VectorXd::Zero(1);
  const Eigen::MatrixXd zeros = Eigen::MatrixXd::Zero(3, 1);
  EXPECT_EQ(CheckGradient(constant, p, zeros).Count(GradientVerdict::kAgrees), 1);
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(3, 1);
  EXPECT_EQ(CheckGradient(constant, p, ones).Count(GradientVerdict::kDisagrees), 1);
}

TEST(GradientCheck, ErrorEstimateBoundsTheError) {
  // A cubic is extrapolated exactly; what remains is roundoff, eps f / step.
  const auto cubic = [](double s, Eigen::VectorXd* f) {
    *f = Eigen::VectorXd::Constant(1, 1.0 + 2.0 * s + 3.0 * s * s + 4.0 * s * s * s);
    return true;
  };
  const Difference d = RiddersDifference(cubic, 0.1);
  ASSERT_EQ(d.derivative.size(), 1);
  EXPECT_LE(std::abs(d.derivative[0] - 2.0), d.error + 1e-14);
  EXPECT_LT(d.error, 1e-6);
}

}  // namespace
}  // namespace clothfit
