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
    : features_(FindFeatures(triangles)), tree_(triangles, x), edges_(features_.edges.size()) {
  RefitEdges();
}

template <int Planes>
void CollisionSurface<Planes>::Refit(const Eigen::VectorXd& x, double margin) {
  tree_.Refit(x, margin);
  RefitEdges();
}

template <int Planes>
void CollisionSurface<Planes>::RefitSwept(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                          double margin) {
  tree_.RefitSwept(x0, x1, margin);
  RefitEdges();
}

template <int Planes>
void CollisionSurface<Planes>::RefitEdges() {
  for (size_t i = 0; i < edges_.size(); ++i) {
    edges_[i] = tree_.vertex(features_.edges[i][0]);
    edges_[i].Merge(tree_.vertex(features_.edges[i][1]));
  }
}

template class CollisionSurface<6>;
template class CollisionSurface<14>;
template class CollisionSurface<18>;
template class CollisionSurface<26>;

}  // namespace clothfit
