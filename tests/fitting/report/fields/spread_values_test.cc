// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Values at some points become values of particles.
#include "fitting/report/fields/spread_values.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(SpreadValues, KeepsAConstant) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {11, 11});
  const std::vector<SurfacePoint> points =
      LocateOnCloth(mesh, {{0.2, 0.2}, {0.8, 0.3}, {0.5, 0.9}});
  SpreadValues spread(mesh, 2);
  for (const SurfacePoint& point : points) spread.Add(1, point, 0.25);
  const std::vector<Eigen::VectorXd> values = spread.Values();
  ASSERT_EQ(values.size(), 2u);
  int known = 0;
  for (const double value : values[1]) {
    if (std::isnan(value)) continue;
    EXPECT_NEAR(value, 0.25, 1e-12);
    ++known;
  }
  EXPECT_GT(known, 60);                                                 // of 121
  for (const double value : values[0]) EXPECT_TRUE(std::isnan(value));  // no point in frame 0
}

TEST(SpreadValues, StaysBetweenItsValuesAndNearThem) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {21, 21});
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, {{0.1, 0.5}, {0.9, 0.5}});
  SpreadValues spread(mesh, 1);
  spread.Add(0, points[0], 1.0);
  spread.Add(0, points[1], 3.0);
  spread.Add(0, points[0], NAN);  // is not counted
  const Eigen::VectorXd values = spread.Values()[0];
  const Eigen::Index left = 2 + 10 * 21, right = 18 + 10 * 21;
  EXPECT_NEAR(values[left], 1.0, 1e-3);
  EXPECT_NEAR(values[right], 3.0, 1e-3);
  for (const double value : values) {
    if (std::isnan(value)) continue;
    EXPECT_TRUE(value >= 1.0 - 1e-12 && value <= 3.0 + 1e-12);
  }
  EXPECT_TRUE(std::isnan(values[0]));  // a corner, 13 edges away from both
}

}  // namespace
}  // namespace clothfit
