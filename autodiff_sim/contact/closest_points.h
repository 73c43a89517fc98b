// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The closest points of a vertex and a triangle, and of two edges. Triangles without area, edges
// without length and parallel edges are answered too, with one of their closest points.
#pragma once

#include <array>

#include <Eigen/Core>

namespace clothfit {

// The points (m) of a pair: a vertex and a triangle's three corners, or an edge's two ends and
// another's.
using FourPoints = std::array<Eigen::Vector3d, 4>;

struct VertexTriangleClosest {
  std::array<double, 3> weights = {1.0, 0.0, 0.0};   // of the corners, 0 or more, sum 1
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // m, from the triangle's point to the vertex
  double distance = 0.0;                             // m
};
VertexTriangleClosest ClosestVertexTriangle(const FourPoints& x);

struct EdgeEdgeClosest {
  std::array<double, 2> along = {0.0, 0.0};  // 0 at an edge's first end, 1 at its second
  Eigen::Vector3d offset =
      Eigen::Vector3d::Zero();  // m, from the second edge's point to the first's
  double distance = 0.0;        // m
  // m^4, squared length of the cross product of the edges: 0 where they are parallel, and there the
  // closest points jump (Li et al. 2020, "Incremental potential contact", sec. 4.4.1).
  double cross_squared = 0.0;
};
EdgeEdgeClosest ClosestEdgeEdge(const FourPoints& x);

}  // namespace clothfit
