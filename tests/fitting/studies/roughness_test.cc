// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/roughness.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// The cloth in the plane z = 0, its part with u > 0.5 turned up by an angle about the line u = 0.5.
Eigen::VectorXd Folded(const ClothMesh& mesh, double angle) {
  Eigen::VectorXd x(3 * mesh.num_particles());
  for (int i = 0; i < mesh.num_particles(); ++i) {
    const double beyond = std::max(0.0, mesh.uv[i].x() - 0.5);
    x.segment<3>(3 * i) = Eigen::Vector3d(mesh.uv[i].x() + beyond * (std::cos(angle) - 1.0),
                                          mesh.uv[i].y(), beyond * std::sin(angle));
  }
  return x;
}

TEST(Roughness, IsTheAngleOfAFold) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {3, 3});
  // A flat cloth has none but rounding, whose angle is that of 1e-16 in a cross product.
  EXPECT_NEAR(Roughness(mesh, Folded(mesh, 0.0)), 0.0, 1e-12);
  // Of the 8 inner edges of 8 triangles the two on the fold bend.
  ASSERT_EQ(BuildTopology(mesh).hinges.size(), 8U);
  for (const double angle : {0.1, 1.0, 3.0})
    EXPECT_NEAR(Roughness(mesh, Folded(mesh, angle)), angle * std::sqrt(2.0 / 8.0), 1e-12);
}

}  // namespace
}  // namespace clothfit
