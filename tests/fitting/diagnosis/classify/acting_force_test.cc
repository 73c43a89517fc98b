// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The region in which a force acts, on cloths of 0.5 m x 0.5 m.
#include "fitting/diagnosis/classify/acting_force.h"

#include <array>
#include <functional>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// N/m^2 at a place of the cloth, along z.
using Pressure = std::function<double(const Eigen::Vector2d& uv)>;

ActingForce ActingOf(int particles, const Pressure& pressure) {
  const ClothMesh mesh = MakeGrid({0.5, 0.5}, {particles, particles});
  const std::vector<double> areas = BuildTopology(mesh).areas;
  const int n = mesh.num_particles();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * n), x = force;
  for (int i = 0; i < n; ++i) {
    force[3 * i + 2] = pressure(mesh.uv[i]) * areas[i];
    x.segment<2>(3 * i) = mesh.uv[i];
  }
  ForceMeter meter(areas, 3);
  for (int frame = 1; frame < 3; ++frame) meter.Add(frame, force, x, x, 0.1);
  return meter.Result(mesh);
}

void ExpectBox(const ActingForce& force, double low_u, double high_u, double low_v, double high_v,
               double tolerance) {
  EXPECT_NEAR(force.low_uv.x(), low_u, tolerance);
  EXPECT_NEAR(force.high_uv.x(), high_u, tolerance);
  EXPECT_NEAR(force.low_uv.y(), low_v, tolerance);
  EXPECT_NEAR(force.high_uv.y(), high_v, tolerance);
}

// The area that the boxes of two forces share, over the area of either.
double SharedBox(const ActingForce& a, const ActingForce& b) {
  const auto area = [](const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    return (high - low).cwiseMax(0.0).prod();
  };
  const double shared = area(a.low_uv.cwiseMax(b.low_uv), a.high_uv.cwiseMin(b.high_uv));
  return shared / (area(a.low_uv, a.high_uv) + area(b.low_uv, b.high_uv) - shared);
}

TEST(ActingRegionTest, OfAnEvenForceIsWhereItActs) {
  ExpectBox(ActingOf(11, [](const auto&) { return 2.0; }), 0.0, 0.5, 0.0, 0.5, 0.011);
  // On whole cells, between particles at multiples of 0.05 m.
  const ActingForce part = ActingOf(11, [](const Eigen::Vector2d& uv) {
    return uv.x() > 0.19 && uv.x() < 0.41 && uv.y() < 0.21 ? 1.0 : 0.0;
  });
  ExpectBox(part, 0.175, 0.425, 0.0, 0.225, 0.02);
}

TEST(ActingRegionTest, IsTheSameOnAFinerMesh) {
  const auto hem = [](int particles) {
    return ActingOf(particles,
                    [](const Eigen::Vector2d& uv) { return uv.y() > 0.499 ? 5.0 : 0.0; });
  };
  const ActingForce coarse = hem(13), fine = hem(17);
  EXPECT_GT(SharedBox(coarse, fine), 0.5);
  EXPECT_GT(coarse.low_uv.y(), 0.45);
  EXPECT_NEAR(coarse.high_uv.y(), 0.5, 1e-9);
}

// One corner has three times what the patch has, per area, which is little of all.
TEST(ActingRegionTest, IsNotThatOfASingleParticle) {
  const auto patch = [](double of_corner) {
    return ActingOf(13, [of_corner](const Eigen::Vector2d& uv) {
      return (uv - Eigen::Vector2d(0.3, 0.2)).norm() < 0.1 ? 1.0
                                                           : (uv.norm() < 0.01 ? of_corner : 0.0);
    });
  };
  const ActingForce without = patch(0.0), with = patch(3.0);
  EXPECT_GT(SharedBox(without, with), 0.8);
  EXPECT_NEAR(with.peak, 3.0, 1e-9);
}

// As a jerk at the start, which damping answers with hundred times what it does later.
TEST(ActingFramesTest, AreNotThoseOfAJerk) {
  const ClothMesh mesh = MakeGrid({0.5, 0.5}, {3, 3});
  const auto frames_of = [&](const std::function<double(int)>& force_of) {
    ForceMeter meter(BuildTopology(mesh).areas, 61);
    for (int frame = 1; frame <= 60; ++frame) {
      const Eigen::VectorXd force = Eigen::VectorXd::Constant(27, force_of(frame));
      meter.Add(frame, force, force, force, 0.04);
    }
    const ActingForce acting = meter.Result(mesh);
    return std::array<int, 2>{acting.first_frame, acting.last_frame};
  };
  EXPECT_EQ(frames_of([](int) { return 1.0; }), (std::array<int, 2>{0, 60}));
  EXPECT_EQ(frames_of([](int f) { return f == 1 ? 100.0 : 1.0; })[0], 0);
  EXPECT_GE(frames_of([](int f) { return f == 1 ? 100.0 : 1.0; })[1], 58);
  EXPECT_EQ(frames_of([](int f) { return f > 20 && f <= 40 ? 1.0 : 0.0; }),
            (std::array<int, 2>{21, 40}));
}

}  // namespace
}  // namespace clothfit
