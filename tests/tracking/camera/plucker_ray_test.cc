// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/plucker_ray.h"

#include <functional>
#include <random>

#include <ceres/jet.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using Jet = ceres::Jet<double, 3>;

// Vectors with coordinates in [-2, 2], the same ones in every run.
class RandomVectors {
 public:
  Eigen::Vector3d Next() { return {unit_(random_), unit_(random_), unit_(random_)}; }

 private:
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> unit_{-2.0, 2.0};
};

constexpr int kTrials = 50;

Eigen::Matrix<Jet, 3, 1> AsJets(const Eigen::Vector3d& point) {
  return {Jet(point.x(), 0), Jet(point.y(), 1), Jet(point.z(), 2)};
}

// d value / d point by central differences, for a value that is at most quadratic around the point.
Eigen::Matrix3d CentralDifferences(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& f,
                                   const Eigen::Vector3d& point) {
  constexpr double kStep = 1e-5;
  Eigen::Matrix3d jacobian;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    jacobian.col(i) = (f(point + step) - f(point - step)) / (2.0 * kStep);
  }
  return jacobian;
}

TEST(RayThrough, HasUnitDirectionAndPerpendicularMomentWhateverThePoint) {
  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const Eigen::Vector3d point = random.Next();
    const Eigen::Vector3d direction = random.Next();
    const PluckerRay<double> ray = RayThrough<double>(point, direction);
    EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-14);
    EXPECT_NEAR(ray.direction.dot(ray.moment), 0.0, 1e-14);
    const PluckerRay<double> same = RayThrough<double>(point + 1.5 * direction, 3.0 * direction);
    EXPECT_LT((same.moment - ray.moment).norm(), 1e-13);
    EXPECT_LT((same.direction - ray.direction).norm(), 1e-13);
  }
}

TEST(RayThroughPixel, PassesThroughEveryPointSeenThere) {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 500.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.distortion = {-0.1, 0.01, 0.001, 0.002, 0.0};
  camera.camera_from_world_rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  camera.camera_from_world_translation = {0.1, 0.2, 0.3};
  for (const double depth : {0.5, 2.0, 10.0}) {
    const Eigen::Vector3d point(0.1 * depth, depth, -0.2 * depth);
    ASSERT_TRUE(IsInFront(camera, point));
    const auto ray = RayThroughPixel(camera, ProjectPoint(camera, point));
    ASSERT_TRUE(ray);
    EXPECT_LT(VectorFromRay<double>(*ray, point).norm(), 1e-12);
    EXPECT_LT(VectorFromRay<double>(*ray, CameraCentre(camera)).norm(), 1e-12);
    EXPECT_GT(ray->direction.dot(point - CameraCentre(camera)), 0.0);
  }
}

TEST(VectorFromRay, PointsFromTheRayToThePoint) {
  // By hand: the ray is the x axis at height 1, the point 2 above it.
  const PluckerRay<double> ray =
      RayThrough<double>(Eigen::Vector3d(5, 0, 1), Eigen::Vector3d(1, 0, 0));
  EXPECT_LT((VectorFromRay<double>(ray, {7, 0, 3}) - Eigen::Vector3d(0, 0, 2)).norm(), 1e-14);

  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const Eigen::Vector3d on_ray = random.Next();
    const Eigen::Vector3d direction = random.Next().normalized();
    const Eigen::Vector3d point = random.Next();
    const Eigen::Vector3d expected = (point - on_ray) - direction * direction.dot(point - on_ray);
    const Eigen::Vector3d vector =
        VectorFromRay<double>(RayThrough<double>(on_ray, direction), point);
    EXPECT_LT((vector - expected).norm(), 1e-13);
  }
}

TEST(VectorFromRay, OfAMeasuredRayHasTheDerivativeOfAProjection) {
  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const PluckerRay<double> ray = RayThrough<double>(random.Next(), random.Next());
    const Eigen::Vector3d point = random.Next();
    const Eigen::Matrix<Jet, 3, 1> vector = VectorFromMeasuredRay<Jet>(ray, AsJets(point));
    const Eigen::Matrix3d numeric = CentralDifferences(
        [&](const Eigen::Vector3d& p) { return VectorFromRay<double>(ray, p); }, point);
    const Eigen::Matrix3d exact =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR(vector[row].v[column], exact(row, column), 1e-13);
        EXPECT_NEAR(numeric(row, column), exact(row, column), 1e-9);
      }
    }
  }
}

TEST(DistanceFromRay, IsThatOfAPointMovedSideways) {
  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const Eigen::Vector3d origin = random.Next();
    const Eigen::Vector3d direction = random.Next();
    const PluckerRay<double> ray = RayThrough<double>(origin, direction);
    const Eigen::Vector3d sideways = ray.direction.cross(random.Next());
    EXPECT_NEAR(DistanceFromRay<double>(ray, origin + 2.0 * direction + sideways), sideways.norm(),
                1e-13);
  }
}

TEST(DistanceFromRay, HasAFiniteDerivativeOnTheRay) {
  const PluckerRay<Jet> ray =
      RayThrough<Jet>(Eigen::Vector3d(0, 0, 0).cast<Jet>(), Eigen::Vector3d(1, 0, 0).cast<Jet>());
  const Jet on_ray = DistanceFromRay<Jet>(ray, AsJets({3, 0, 0}));
  EXPECT_EQ(on_ray.a, 0.0);
  EXPECT_TRUE(on_ray.v.isZero());
  const Jet off_ray = DistanceFromRay<Jet>(ray, AsJets({3, 0, 2}));
  EXPECT_EQ(off_ray.a, 2.0);
  EXPECT_LT((off_ray.v - Eigen::Vector3d(0, 0, 1)).norm(), 1e-14);
}

TEST(ClosestPointOnRay, LiesOnItAndTheConnectionIsPerpendicularToBoth) {
  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const PluckerRay<double> ray_i = RayThrough<double>(random.Next(), random.Next());
    const PluckerRay<double> ray_j = RayThrough<double>(random.Next(), random.Next());
    const auto on_i = ClosestPointOnRay<double>(ray_i, ray_j);
    const auto on_j = ClosestPointOnRay<double>(ray_j, ray_i);
    ASSERT_TRUE(on_i && on_j);
    EXPECT_LT(DistanceFromRay<double>(ray_i, *on_i), 1e-11);
    EXPECT_LT(DistanceFromRay<double>(ray_j, *on_j), 1e-11);
    const Eigen::Vector3d connection = *on_i - *on_j;
    EXPECT_NEAR(connection.dot(ray_i.direction), 0.0, 1e-11);
    EXPECT_NEAR(connection.dot(ray_j.direction), 0.0, 1e-11);
  }
}

TEST(ClosestPointOnRay, IsTheIntersectionWhereThereIsOne) {
  RandomVectors random;
  for (int i = 0; i < kTrials; ++i) {
    const Eigen::Vector3d point = random.Next();
    const auto closest = ClosestPointOnRay<double>(RayThrough<double>(point, random.Next()),
                                                   RayThrough<double>(point, random.Next()));
    ASSERT_TRUE(closest);
    EXPECT_LT((*closest - point).norm(), 1e-11);
  }
}

TEST(ClosestPointOnRay, IsEmptyForParallelRays) {
  const Eigen::Vector3d direction(1, 2, 3);
  const PluckerRay<double> ray = RayThrough<double>(Eigen::Vector3d(0, 0, 0), direction);
  const Eigen::Vector3d beside(1, 0, 0);
  EXPECT_FALSE(ClosestPointOnRay<double>(ray, RayThrough<double>(beside, direction)));
  const Eigen::Vector3d opposite = -direction;
  EXPECT_FALSE(ClosestPointOnRay<double>(ray, RayThrough<double>(beside, opposite)));
  EXPECT_FALSE(ClosestPointOnRay<double>(ray, ray));
  const Eigen::Vector3d turned = direction + Eigen::Vector3d(1e-4, 0, 0);
  EXPECT_TRUE(ClosestPointOnRay<double>(ray, RayThrough<double>(beside, turned)));
}

TEST(ClosestPointOnRay, JetsAgreeWithCentralDifferences) {
  RandomVectors random;
  int checked = 0;
  for (int i = 0; i < kTrials; ++i) {
    const Eigen::Vector3d origin = random.Next();
    const Eigen::Vector3d direction = random.Next();
    const PluckerRay<double> ray_j = RayThrough<double>(random.Next(), random.Next());
    const PluckerRay<double> ray_i = RayThrough<double>(origin, direction);
    if (ray_i.direction.cross(ray_j.direction).norm() < 0.3) continue;  // too curved to difference
    const auto closest =
        ClosestPointOnRay<Jet>(RayThrough<Jet>(AsJets(origin), direction.cast<Jet>()),
                               {ray_j.direction.cast<Jet>(), ray_j.moment.cast<Jet>()});
    ASSERT_TRUE(closest);
    const Eigen::Matrix3d numeric = CentralDifferences(
        [&](const Eigen::Vector3d& p) {
          return *ClosestPointOnRay<double>(RayThrough<double>(p, direction), ray_j);
        },
        origin);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR((*closest)[row].v[column], numeric(row, column), 1e-8);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 9 * kTrials / 2);
}

}  // namespace
}  // namespace clothfit
