// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/closest_on_mesh.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/crumpled_cloth.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

double LeastByAll(const CrumpledCloth& cloth, const Eigen::VectorXd& x, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : cloth.mesh.triangles) {
    least = std::min(least, ClosestVertexTriangle({point, x.segment<3>(3 * a), x.segment<3>(3 * b),
                                                   x.segment<3>(3 * c)})
                                .distance);
  }
  return least;
}

TEST(ClosestOnMesh, IsThatOfAllTriangles) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const CrumpledCloth cloth = Crumple(seed);
    ClosestOnMesh surface(cloth.mesh.triangles, cloth.x);
    Eigen::VectorXd x = cloth.x;
    for (const double moved : {0.0, 0.2}) {  // the tree's shape is that of another place
      for (double& value : x) value += moved * normal(random);
      surface.MoveTo(x);
      for (int i = 0; i < 200; ++i, ++compared) {
        const double spread = i % 2 == 0 ? 0.3 : 3.0;
        Vector3d offset;
        for (double& value : offset.reverse()) value = normal(random);
        const Vector3d point = Vector3d(0.4, 0.3, 0.0) + spread * offset;
        const auto [triangle, closest] = surface.Find(point);
        EXPECT_EQ(closest.distance, LeastByAll(cloth, x, point));
        const auto& [a, b, c] = cloth.mesh.triangles[triangle];
        const Vector3d found = closest.weights[0] * x.segment<3>(3 * a) +
                               closest.weights[1] * x.segment<3>(3 * b) +
                               closest.weights[2] * x.segment<3>(3 * c);
        EXPECT_LT((point - found - closest.offset).norm(), 1e-12);  // rounding at 3 m
      }
    }
  }
  EXPECT_EQ(compared, 1200);
}

TEST(ClosestOnMesh, FindsItsOwnParticles) {
  const CrumpledCloth cloth = Crumple(4);
  const ClosestOnMesh surface(cloth.mesh.triangles, cloth.x);
  for (int i = 0; i < cloth.mesh.num_particles(); ++i)
    EXPECT_EQ(surface.Find(cloth.x.segment<3>(3 * i)).on_triangle.distance, 0.0);
}

}  // namespace
}  // namespace clothfit
