// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/collision_surface.h"

namespace clothfit {
namespace {

Eigen::VectorXd FlatShape(const ClothMesh& mesh) {
  Eigen::VectorXd x(3 * mesh.num_particles());
  for (int i = 0; i < mesh.num_particles(); ++i) x.segment<3>(3 * i) << mesh.uv[i], 0.0;
  return x;
}

}  // namespace

template <int Planes>
CollisionSurface<Planes>::CollisionSurface(const ClothMesh& mesh)
    : CollisionSurface(mesh.triangles, FlatShape(mesh)) {}

template <int Planes>
CollisionSurface<Planes>::CollisionSurface(const std::vector<std::array<int, 3>>& triangles,
                                           const Eigen::VectorXd& x)
    : features(FindFeatures(triangles)), tree(triangles, x) {}

template struct CollisionSurface<6>;
template struct CollisionSurface<14>;
template struct CollisionSurface<18>;
template struct CollisionSurface<26>;

}  // namespace clothfit
