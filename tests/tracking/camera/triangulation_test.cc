// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/triangulation.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tracking/synthetic/cameras.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

PluckerRay<double> Through(const Vector3d& a, const Vector3d& b) {
  return RayThrough<double>(a, b - a);
}

TEST(MeanClosestPoint, OfRaysThatMeetIsWhereTheyMeetWhateverTheirNumber) {
  const Vector3d meeting(0.3, -0.2, 1.1);
  std::vector<PluckerRay<double>> rays;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int n = 1; n <= 7; ++n) {
    rays.push_back(Through({normal(random), normal(random), normal(random)}, meeting));
    const std::optional<Vector3d> point = MeanClosestPoint(rays);
    ASSERT_EQ(point.has_value(), n >= 2);
    if (n >= 2) {
      EXPECT_LT((*point - meeting).norm(), 1e-12) << n;
    }
  }
}

TEST(MeanClosestPoint, OfTwoRaysThatMissIsTheMiddleBetweenThem) {
  const PluckerRay<double> along_x = RayThrough<double>(Vector3d(5, 0, 0), Vector3d::UnitX());
  const PluckerRay<double> along_y = RayThrough<double>(Vector3d(0, 3, 1), Vector3d::UnitY());
  EXPECT_LT((*MeanClosestPoint({along_x, along_y}) - Vector3d(0, 0, 0.5)).norm(), 1e-12);
}

TEST(MeanClosestPoint, LeavesParallelPairsOut) {
  const PluckerRay<double> a = RayThrough<double>(Vector3d(0, 0, 0), Vector3d::UnitX());
  const PluckerRay<double> b = RayThrough<double>(Vector3d(0, 1, 0), Vector3d::UnitX());
  const PluckerRay<double> c = RayThrough<double>(Vector3d(2, 0, 0), Vector3d::UnitY());
  EXPECT_FALSE(MeanClosestPoint({a, b}).has_value());
  // c meets a in (2, 0, 0) and b in (2, 1, 0); a and b have no points.
  EXPECT_LT((*MeanClosestPoint({a, b, c}) - Vector3d(2, 0.5, 0)).norm(), 1e-12);
}

// The paper's factor 1 / N instead would put the mean of N rays N - 1 times as far from the origin.
TEST(MeanClosestPoint, DoesNotDependOnTheOrigin) {
  const Vector3d shift(10, -4, 2);
  std::vector<PluckerRay<double>> rays, shifted;
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 5; ++n) {
    Vector3d from, to;
    for (double& value : from.reverse()) value = normal(random);
    for (double& value : to.reverse()) value = normal(random);
    rays.push_back(Through(from, to));
    shifted.push_back(Through(from + shift, to + shift));
  }
  EXPECT_LT((*MeanClosestPoint(shifted) - *MeanClosestPoint(rays) - shift).norm(), 1e-11);
}

struct Views {
  explicit Views(int count) : cameras(MakeCameraRing(count, Vector3d::Zero(), 3.0)), random(17) {}

  std::vector<Sighting> Of(const Vector3d& point, double sigma) {
    std::normal_distribution<double> normal;
    std::vector<Sighting> sightings;
    for (int c = 0; c < static_cast<int>(cameras.size()); ++c) {
      Eigen::Vector2d error;
      for (double& value : error.reverse()) value = normal(random);
      sightings.push_back({c, ProjectPoint(cameras[c], point) + sigma * error});
    }
    return sightings;
  }
  Vector3d Point() {
    std::uniform_real_distribution<double> unit(-0.4, 0.4);
    return {unit(random), unit(random), unit(random)};
  }

  std::vector<Camera> cameras;
  std::mt19937 random;
};

TEST(TriangulateRobustly, IsExactWithoutNoise) {
  Views views(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Vector3d point = views.Point();
    const std::optional<Triangulation> found =
        TriangulateRobustly(views.cameras, views.Of(point, 0.0));
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((found->position - point).norm(), 1e-8);
    EXPECT_EQ(found->num_agreeing, 7);
  }
}

TEST(TriangulateRobustly, NeedsTwoRaysThatAreNotParallel) {
  Views views(3);
  const std::vector<Sighting> all = views.Of({0.1, 0.2, 0.0}, 0.0);
  EXPECT_FALSE(TriangulateRobustly(views.cameras, {}).has_value());
  EXPECT_FALSE(TriangulateRobustly(views.cameras, {all[0]}).has_value());
  EXPECT_TRUE(TriangulateRobustly(views.cameras, {all[0], all[1]}).has_value());
  EXPECT_FALSE(TriangulateRobustly(views.cameras, {all[0], all[0]}).has_value());
}

// Under noise alone the refined point is better than the mean of closest points.
TEST(TriangulateRobustly, HasTheLeastReprojectionError) {
  Views views(5);
  double refined = 0.0, mean = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d point = views.Point();
    const std::vector<Sighting> sightings = views.Of(point, 0.5);
    const Triangulation found = *TriangulateRobustly(views.cameras, sightings);
    std::vector<PluckerRay<double>> rays;
    for (const Sighting& s : sightings)
      rays.push_back(*RayThroughPixel(views.cameras[s.camera], s.pixel));
    refined += (found.position - point).squaredNorm();
    mean += (*MeanClosestPoint(rays) - point).squaredNorm();
    // Nudged to any side, the reprojection error grows.
    const auto cost = [&](const Vector3d& at) {
      double sum = 0.0;
      for (const double e : ReprojectionErrors(views.cameras, sightings, at)) sum += e * e;
      return sum;
    };
    for (int k = 0; k < 3 && found.num_agreeing == 5; ++k) {
      for (const double step : {-1e-5, 1e-5}) {
        EXPECT_GT(cost(found.position + step * Vector3d::Unit(k)), cost(found.position));
      }
    }
  }
  EXPECT_LT(refined, mean);
}

class WithOutliers : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Share, WithOutliers, testing::Values(0.05, 0.2, 0.4));

// Each sighting is an outlier with that probability. Where at least three true ones are left, the
// point is found as if the others were not there.
TEST_P(WithOutliers, FindsThePointThatMostAgreeOn) {
  Views views(7);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  int found_right = 0, tried = 0, outliers = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3d point = views.Point();
    std::vector<Sighting> sightings = views.Of(point, 0.3);
    int good = 0;
    for (Sighting& s : sightings) {
      if (chance(views.random) < GetParam()) {
        s.pixel = {640.0 * chance(views.random), 480.0 * chance(views.random)};
        ++outliers;
      } else {
        ++good;
      }
    }
    if (good < 3) continue;
    ++tried;
    const std::optional<Triangulation> found = TriangulateRobustly(views.cameras, sightings);
    // 0.3 px at 3 m and 720 px focal length is 1.3 mm; three cameras may stand badly.
    if (found && (found->position - point).norm() < 0.01) ++found_right;
  }
  EXPECT_GT(outliers, 50);
  EXPECT_GT(tried, 250);
  EXPECT_GE(found_right, 0.99 * tried);
}

}  // namespace
}  // namespace clothfit
