// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/term/fold_angle.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// Two triangles whose shared edge lies along y, folded by an angle (rad).
std::array<Eigen::Vector3d, 4> FoldedTriangles(double angle) {
  return {Eigen::Vector3d(0.7, 0.2, 0.0),
          Eigen::Vector3d(-0.6 * std::cos(angle), 0.5, -0.6 * std::sin(angle)),
          Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, 1.1, 0.0)};
}

TEST(FoldAngle, IsThatOfTheTriangles) {
  for (int i = -17; i <= 17; ++i) {
    const double angle = M_PI * i / 18.0;
    EXPECT_NEAR(std::abs(FoldAngle<double>(MakeFold<double>(FoldedTriangles(angle)))),
                std::abs(angle), 1e-14);
    EXPECT_NEAR(FoldAngle<double>(MakeFold<double>(FoldedTriangles(-angle))),
                -FoldAngle<double>(MakeFold<double>(FoldedTriangles(angle))), 1e-14);
  }
}

// Also where the fold is nearly shut, of either sign, and far smaller than its roundoff elsewhere.
TEST(FoldAngle, IsHalvedWithoutBeingComputed) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int obtuse = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<Eigen::Vector3d, 4> x;
    for (Eigen::Vector3d& p : x) p << uniform(random), uniform(random), uniform(random);
    const Fold<double> fold = MakeFold<double>(x);
    const double half = 0.5 * FoldAngle<double>(fold);
    const HalfAngle<double> halved = HalveAngle<double>(fold);
    EXPECT_NEAR(halved.sine, std::sin(half), 1e-14);
    EXPECT_NEAR(halved.cosine, std::cos(half), 1e-14);
    if (fold.cosine < 0.0) ++obtuse;
  }
  EXPECT_GT(obtuse, 100);
  for (const double angle : {1e-9, -1e-9}) {
    const Fold<double> fold = MakeFold<double>(FoldedTriangles(angle));
    const double sine = HalveAngle<double>(fold).sine;
    EXPECT_NEAR(sine, 0.5 * FoldAngle<double>(fold), 1e-8 * std::abs(sine));
  }
  for (const double angle : {M_PI - 1e-9, 1e-9 - M_PI}) {
    const Fold<double> fold = MakeFold<double>(FoldedTriangles(angle));
    EXPECT_GT(HalveAngle<double>(fold).sine * FoldAngle<double>(fold), 0.0);
    EXPECT_NEAR(HalveAngle<double>(fold).cosine, 5e-10, 1e-15);
  }
}

}  // namespace
}  // namespace clothfit
