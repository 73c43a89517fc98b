// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/closest_on_mesh.h"

namespace clothfit {

ClosestOnMesh::ClosestOnMesh(const std::vector<std::array<int, 3>>& triangles,
                             const Eigen::VectorXd& x)
    : triangles_(triangles), tree_(triangles, x), x_(x) {}

void ClosestOnMesh::MoveTo(const Eigen::VectorXd& x) {
  x_ = x;
  tree_.Refit(x, 0.0);
}

FourPoints ClosestOnMesh::WithTriangle(const Eigen::Vector3d& point, int triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {point, x_.segment<3>(3 * a), x_.segment<3>(3 * b), x_.segment<3>(3 * c)};
}

ClosestOnMesh::Closest ClosestOnMesh::Find(const Eigen::Vector3d& point) const {
  const int nearest = tree_.Nearest(point, [&](int triangle) {
    return ClosestVertexTriangle(WithTriangle(point, triangle)).offset.squaredNorm();
  });
  return {nearest, ClosestVertexTriangle(WithTriangle(point, nearest))};
}

}  // namespace clothfit
