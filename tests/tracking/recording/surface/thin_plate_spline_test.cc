// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/thin_plate_spline.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// Nine points of a 0.3 m cloth, a third of its size apart from its edges at most.
Eigen::Matrix2Xd Sites() {
  Eigen::Matrix2Xd sites(2, 9);
  sites << 0.02, 0.16, 0.29, 0.01, 0.14, 0.30, 0.03, 0.17, 0.28,  //
      0.01, 0.02, 0.00, 0.16, 0.13, 0.15, 0.29, 0.30, 0.28;
  return sites;
}

Eigen::Vector3d Affine(const Eigen::Vector2d& p) {
  Eigen::Matrix<double, 3, 2> linear;
  linear << 0.9, -0.1, 0.2, 0.3, -0.1, -1.1;
  return linear * p + Eigen::Vector3d(1.0, -2.0, 3.0);
}

// A sheet rolled onto a cylinder of radius 0.2 m.
Eigen::Vector3d Rolled(const Eigen::Vector2d& p) {
  constexpr double kRadius = 0.2;
  return {kRadius * std::sin(p.x() / kRadius), p.y(), kRadius * std::cos(p.x() / kRadius)};
}

template <class Function>
Eigen::Matrix3Xd Values(const Eigen::Matrix2Xd& sites, const Function& function) {
  Eigen::Matrix3Xd values(3, sites.cols());
  for (Eigen::Index i = 0; i < sites.cols(); ++i) values.col(i) = function(sites.col(i));
  return values;
}

TEST(ThinPlateSpline, ReproducesAffineMapsEverywhere) {
  const ThinPlateSpline surface(Sites(), Values(Sites(), Affine));
  int checked = 0;
  for (double u = -1.0; u <= 1.0; u += 0.1) {
    for (double v = -1.0; v <= 1.0; v += 0.1) {
      EXPECT_LT((surface({u, v}) - Affine({u, v})).norm(), 1e-12);
      ++checked;
    }
  }
  EXPECT_GT(checked, 400);
}

TEST(ThinPlateSpline, ReproducesAffineMapsFromThreePoints) {
  const Eigen::Matrix2Xd sites = Sites().leftCols(4).rightCols(3);
  const ThinPlateSpline surface(sites, Values(sites, Affine));
  EXPECT_LT((surface({0.3, 0.3}) - Affine({0.3, 0.3})).norm(), 1e-12);
}

TEST(ThinPlateSpline, GoesThroughItsPoints) {
  const Eigen::Matrix3Xd values = Values(Sites(), Rolled);
  const ThinPlateSpline surface(Sites(), values);
  for (Eigen::Index i = 0; i < 9; ++i) {
    EXPECT_LT((surface(Sites().col(i)) - values.col(i)).norm(), 1e-13);
  }
}

TEST(ThinPlateSpline, DoesNotDependOnUnitsOrPlace) {
  const Eigen::Matrix3Xd values = Values(Sites(), Rolled);
  const ThinPlateSpline surface(Sites(), values);
  const Eigen::Vector2d offset(30.0, -50.0);
  const Eigen::Matrix2Xd moved = (1000.0 * Sites()).colwise() + offset;
  const ThinPlateSpline moved_surface(moved, values);
  const Eigen::Vector2d point(0.07, 0.22);
  EXPECT_LT((surface(point) - moved_surface(1000.0 * point + offset)).norm(), 1e-12);
}

TEST(ThinPlateSpline, StaysNearTheSheetBetweenItsPointsAndAtTheCorners) {
  const ThinPlateSpline surface(Sites(), Values(Sites(), Rolled));
  int checked = 0;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const Eigen::Vector2d point(0.03 * i, 0.03 * j);
      // Never worse than straight lines between neighbours, whose sagitta is 14 mm.
      EXPECT_LT((surface(point) - Rolled(point)).norm(), 0.014) << point.transpose();
      ++checked;
    }
  }
  EXPECT_EQ(checked, 121);
}

TEST(ThinPlateSpline, SmoothingTakesNoiseOut) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  Eigen::Matrix2Xd sites(2, 100);
  for (int i = 0; i < 100; ++i) sites.col(i) = Eigen::Vector2d(i / 10, i % 10);
  Eigen::Matrix3Xd values = Values(sites, Affine);
  for (double& value : values.reshaped()) value += noise(random);
  const auto error = [&](double smoothing) {
    const ThinPlateSpline surface(sites, values, smoothing);
    double sum = 0.0;
    for (int i = 0; i < 100; ++i) sum += (surface(sites.col(i)) - Affine(sites.col(i))).norm();
    return sum / 100;
  };
  EXPECT_LT(error(1.0), 0.5 * error(0.0));
}

TEST(ThinPlateSpline, RefusesSitesThatDetermineNoSurface) {
  const Eigen::Matrix3Xd values = Eigen::Matrix3Xd::Random(3, 4);
  Eigen::Matrix2Xd line(2, 4);
  line << 0, 1, 2, 3, 0, 1, 2, 3;
  EXPECT_THROW(ThinPlateSpline(line, values), std::invalid_argument);
  Eigen::Matrix2Xd twice(2, 4);
  twice << 0, 1, 0, 0, 0, 0, 1, 1;
  EXPECT_THROW(ThinPlateSpline(twice, values), std::invalid_argument);
  EXPECT_THROW(ThinPlateSpline(line.leftCols(2), values.leftCols(2)), std::invalid_argument);
}

}  // namespace
}  // namespace clothfit
