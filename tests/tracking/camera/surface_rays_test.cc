// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/surface_rays.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

// A cloth in waves, so that rays meet it several times.
struct Waves {
  Waves()
      : mesh(MakeGrid({1.0, 1.0}, {15, 15})), x(3 * mesh.num_particles()), rays(mesh.triangles) {
    for (int i = 0; i < mesh.num_particles(); ++i) {
      const Eigen::Vector2d uv = mesh.uv[i];
      x.segment<3>(3 * i) = Eigen::Vector3d(uv.x(), uv.y(), 0.2 * std::sin(9.0 * uv.x()));
    }
    rays.MoveTo(x);
  }
  ClothMesh mesh;
  Eigen::VectorXd x;
  SurfaceRays rays;
};

// The nearest triangle met, by trying all of them.
std::optional<double> BruteForce(const Waves& waves, const Eigen::Vector3d& origin,
                                 const Eigen::Vector3d& unit) {
  std::optional<double> nearest;
  for (const std::array<int, 3>& nodes : waves.mesh.triangles) {
    Eigen::Matrix3d system;
    const Eigen::Vector3d a = waves.x.segment<3>(3 * nodes[0]);
    system << -unit, waves.x.segment<3>(3 * nodes[1]) - a, waves.x.segment<3>(3 * nodes[2]) - a;
    const Eigen::Vector3d s = system.fullPivLu().solve(origin - a);
    if (s[0] < 0.0 || s[1] < 0.0 || s[2] < 0.0 || s[1] + s[2] > 1.0) continue;
    if (!nearest || s[0] < *nearest) nearest = s[0];
  }
  return nearest;
}

TEST(SurfaceRays, FindTheFirstOfAllTriangles) {
  const Waves waves;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    Eigen::Vector3d origin;
    origin.z() = unit(random);
    origin.y() = 0.5 + 2.0 * unit(random);
    origin.x() = 0.5 + 2.0 * unit(random);
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    target.y() = 0.5 + 0.6 * unit(random);
    target.x() = 0.5 + 0.6 * unit(random);
    const Eigen::Vector3d direction = (target - origin).normalized();
    const std::optional<double> expected = BruteForce(waves, origin, direction);
    const std::optional<SurfaceHit> found = waves.rays.First(origin, 3.0 * direction);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (!found) continue;
    ++hits;
    EXPECT_NEAR(found->distance, *expected, 1e-9);  // double precision, though Embree's is single
    EXPECT_LT((found->on_surface.At(waves.x) - (origin + found->distance * direction)).norm(),
              1e-9);
    EXPECT_NEAR(found->normal.norm(), 1.0, 1e-12);
  }
  EXPECT_GT(hits, 100);
}

TEST(SurfaceRays, AreBlockedByWhatLiesBetweenAndNotByTheEnd) {
  const Waves waves;
  const Eigen::Vector3d above(0.5, 0.5, 1.0);
  const Eigen::Vector3d on_top =
      above +
      waves.rays.First(above, -Eigen::Vector3d::UnitZ())->distance * -Eigen::Vector3d::UnitZ();
  EXPECT_FALSE(waves.rays.IsBlocked(above, on_top, 1e-4));
  EXPECT_TRUE(waves.rays.IsBlocked(above, on_top - 0.01 * Eigen::Vector3d::UnitZ(), 1e-4));
  EXPECT_FALSE(waves.rays.IsBlocked(above, Eigen::Vector3d(3.0, 0.5, -1.0), 1e-4));
}

TEST(SurfaceRays, FollowTheSurface) {
  Waves waves;
  const Eigen::Vector3d above(0.5, 0.5, 1.0);
  const double before = waves.rays.First(above, -Eigen::Vector3d::UnitZ())->distance;
  for (Eigen::Index i = 2; i < waves.x.size(); i += 3) waves.x[i] -= 0.25;
  waves.rays.MoveTo(waves.x);
  EXPECT_NEAR(waves.rays.First(above, -Eigen::Vector3d::UnitZ())->distance, before + 0.25, 1e-12);
}

TEST(SurfaceRays, MeetNothingBeforeThereIsASurface) {
  const SurfaceRays rays({{0, 1, 2}});
  EXPECT_FALSE(rays.First(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()).has_value());
  EXPECT_FALSE(rays.IsBlocked(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 0.0));
}

}  // namespace
}  // namespace clothfit
