// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/obstacle_shapes.h"

#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "autodiff_sim/contact/shape_contact.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;
using Jet = ceres::Jet<double, 3>;

const std::vector<ObstacleShape> kShapes = {HalfSpace{}, Sphere(0.5), Capsule{0.3, 0.6},
                                            Box{{0.2, 0.4, 0.6}}};

Vector3d RandomPoint(std::mt19937* random) {
  std::uniform_real_distribution<double> place(-1.2, 1.2);
  const double x = place(*random), y = place(*random), z = place(*random);
  return {x, y, z};
}

RigidPose RandomPose(std::mt19937* random) {
  const Vector3d axis = RandomPoint(random).normalized();
  return {Eigen::AngleAxisd(2.0 * RandomPoint(random).x(), axis).toRotationMatrix(),
          0.5 * RandomPoint(random)};
}

// The distance and a gradient of length 1 lead to the surface, and no point is closer: the distance
// changes by no more than the way.
TEST(ObstacleShapes, DistancesLeadToTheSurface) {
  std::mt19937 random(1);
  for (const ObstacleShape& shape : kShapes) {
    int inside = 0;
    for (int i = 0; i < 1000; ++i) {
      const RigidPose pose = RandomPose(&random);
      const Vector3d p = RandomPoint(&random), q = RandomPoint(&random);
      const auto [distance, gradient] = DistanceInWorld<double>(shape, pose, p);
      EXPECT_NEAR(gradient.norm(), 1.0, 1e-14);
      const Vector3d on_surface = p - distance * gradient;
      EXPECT_NEAR(DistanceInWorld<double>(shape, pose, on_surface).distance, 0.0, 1e-14);
      const double change = DistanceInWorld<double>(shape, pose, q).distance - distance;
      EXPECT_LE(std::abs(change), (p - q).norm() + 1e-14);
      if (distance < 0.0) ++inside;
    }
    EXPECT_GT(inside, 20);
    EXPECT_LT(inside, 980);
  }
}

TEST(ObstacleShapes, PlainDistances) {
  EXPECT_EQ(HalfSpace{}.Distance<double>({3.0, 4.0, -2.0}).distance, -2.0);
  EXPECT_EQ(Sphere(1.0).Distance<double>({3.0, 0.0, 4.0}).distance, 4.0);
  EXPECT_EQ(Sphere(1.0).Distance<double>({0.0, 0.0, 0.0}).distance, -1.0);
  const Capsule capsule{1.0, 2.0};
  EXPECT_EQ(capsule.Distance<double>({3.0, 0.0, 1.0}).distance, 2.0);
  EXPECT_EQ(capsule.Distance<double>({3.0, 0.0, -6.0}).distance, 4.0);
  EXPECT_EQ(capsule.Distance<double>({0.0, 0.0, 1.0}).distance, -1.0);
  const Box box{{1.0, 2.0, 3.0}};
  EXPECT_EQ(box.Distance<double>({4.0, 6.0, 0.0}).distance, 5.0);
  EXPECT_EQ(box.Distance<double>({0.0, 0.0, 0.0}).distance, -1.0);
  EXPECT_EQ(box.Distance<double>({0.5, -1.75, 0.0}).gradient, Vector3d(0.0, -1.0, 0.0));
  EXPECT_EQ(box.Distance<double>({-1.0, 0.5, 0.0}).gradient, Vector3d(-1.0, 0.0, 0.0));
}

// With a Jet the distance's derivatives are the gradient, and the gradient's are its differences.
TEST(ObstacleShapes, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(2);
  constexpr double kDifference = 1e-6;
  int checked = 0;
  for (const ObstacleShape& shape : kShapes) {
    for (int i = 0; i < 200; ++i) {
      const RigidPose pose = RandomPose(&random);
      const Vector3d p = RandomPoint(&random);
      Vector3<Jet> point;
      for (int k = 0; k < 3; ++k) point[k] = Jet(p[k], k);
      const SignedDistance<Jet> found = DistanceInWorld<Jet>(shape, pose, point);
      if (std::abs(found.distance.a) < 0.02) continue;  // second derivatives go with 1 / distance
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(found.distance.v[k], found.gradient[k].a, 1e-13);
        const Vector3d step = kDifference * Vector3d::Unit(k);
        const auto ahead = DistanceInWorld<double>(shape, pose, p + step);
        const auto behind = DistanceInWorld<double>(shape, pose, p - step);
        const Vector3d slope = (ahead.gradient - behind.gradient) / (2.0 * kDifference);
        if (slope.norm() > 100.0) continue;  // across an edge of the inside, where it jumps
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(found.gradient[j].v[k], slope[j], 1e-5);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1500);
}

TEST(ShapeContact, ContinuousNeverMisses) {
  std::mt19937 random(3);
  constexpr int kSamples = 100;
  int met = 0, missed = 0;
  for (const ObstacleShape& shape : kShapes) {
    for (int i = 0; i < 500; ++i) {
      const RigidPose start = RandomPose(&random);
      RigidPose end = RandomPose(&random);
      if (i % 2 == 0) end.world_from_body = start.world_from_body;
      const RigidMotion motion(start, end);
      const Vector3d p0 = RandomPoint(&random), p1 = RandomPoint(&random);
      const Approach approach{i % 3 == 0 ? 0.05 : 0.0, i % 5 == 0 ? 1e-4 : 1.0, 0.1};
      const auto gap = [&](double t) {
        const Vector3d p = p0 + t * (p1 - p0);
        return DistanceInWorld<double>(shape, motion.At(t), p).distance - approach.separation;
      };
      const std::optional<double> time = FirstShapeApproach(p0, p1, shape, motion, approach);
      time ? ++met : ++missed;
      if (gap(0.0) <= 0.0) {
        EXPECT_EQ(time, 0.0);
        continue;
      }
      for (int k = 0; k <= kSamples; ++k) EXPECT_GT(gap(time.value_or(1.0) * k / kSamples), 0.0);
      if (time) {
        EXPECT_LE(gap(*time), std::min(approach.tolerance, approach.slack * gap(0.0)) + 1e-12);
      }
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(missed, 300);
}

TEST(ShapeContact, ListsParticles) {
  Eigen::VectorXd x0(9), x1(9);
  x0 << 0.0, 0.0, 0.05, 1.0, 0.0, 0.2, 2.0, 0.0, -0.1;
  x1 = x0;
  x1[2] -= 0.1;  // the first falls through the plane, at half of the step
  const RigidPose here;
  const RigidMotion rest(here, here);
  const std::vector<ShapeContact> close = FindShapeProximity(x0, HalfSpace{}, here, 0.1);
  ASSERT_EQ(close.size(), 2u);
  EXPECT_EQ(close[0].particle, 0);
  EXPECT_EQ(close[0].distance, 0.05);
  EXPECT_EQ(close[1].particle, 2);
  EXPECT_EQ(close[1].normal, Vector3d::UnitZ().eval());

  const Motion move{x0, x1};
  const Approach approach;
  const std::vector<ShapeImpact> impacts = FindShapeContinuous(move, HalfSpace{}, rest, approach);
  ASSERT_EQ(impacts.size(), 2u);
  EXPECT_NEAR(impacts[0].time, 0.5, approach.tolerance / 0.1 + 1e-12);
  EXPECT_EQ(impacts[1].time, 0.0);
  EXPECT_EQ(EarliestShapeImpact(move, HalfSpace{}, rest, approach), 0.0);
}

TEST(RigidMotion, GoesFromOnePoseToTheOther) {
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    const RigidPose start = RandomPose(&random), end = RandomPose(&random);
    const RigidMotion motion(start, end);
    EXPECT_LE((motion.At(0.0).world_from_body - start.world_from_body).norm(), 1e-14);
    EXPECT_LE((motion.At(1.0).world_from_body - end.world_from_body).norm(), 1e-13);
    EXPECT_LE((motion.At(1.0).origin_in_world - end.origin_in_world).norm(), 1e-15);
    EXPECT_GE(motion.angle(), 0.0);
    EXPECT_LE(motion.angle(), M_PI + 1e-12);
    Eigen::VectorXd x_in_body(6);
    x_in_body << 0.0, 0.0, 0.0, RandomPoint(&random);
    const Eigen::VectorXd x = PlaceInWorld(end, x_in_body);
    EXPECT_EQ(x.head<3>(), end.origin_in_world);
    EXPECT_NEAR((x.tail<3>() - x.head<3>()).norm(), x_in_body.tail<3>().norm(), 1e-14);
  }
}

}  // namespace
}  // namespace clothfit
