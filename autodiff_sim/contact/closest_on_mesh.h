// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The closest point of a moving mesh to a point in space, by a tree of boxes.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/closest_points.h"
#include "autodiff_sim/contact/dop_tree.h"

namespace clothfit {

class ClosestOnMesh {
 public:
  // At least one triangle; particles at x (3N, m), as DopTree.
  ClosestOnMesh(const std::vector<std::array<int, 3>>& triangles, const Eigen::VectorXd& x);

  void MoveTo(const Eigen::VectorXd& x);

  struct Closest {
    int triangle = 0;
    VertexTriangleClosest on_triangle;
  };
  // The same as by looking at all triangles; calls may run at the same time.
  Closest Find(const Eigen::Vector3d& point) const;

 private:
  FourPoints WithTriangle(const Eigen::Vector3d& point, int triangle) const;

  std::vector<std::array<int, 3>> triangles_;
  DopTree<6> tree_;
  Eigen::VectorXd x_;
};

}  // namespace clothfit
