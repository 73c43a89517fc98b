// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Does a cloth pass through itself, or through an obstacle, right now?
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/collision_surface.h"

namespace clothfit {

// An edge that meets a triangle, numbered as in MeshFeatures.
struct EdgeTriangle {
  int edge;
  int triangle;
};
inline bool operator<(const EdgeTriangle& a, const EdgeTriangle& b) {
  return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
}
inline bool operator==(const EdgeTriangle& a, const EdgeTriangle& b) {
  return a.edge == b.edge && a.triangle == b.triangle;
}

// All edges and triangles of a surface at x (3N, m) that meet, by EdgeMeetsTriangle(), those with a
// vertex in common excepted; sorted. Empty exactly where no two parts of the surface without a
// vertex in common touch or cross.
template <int Planes>
std::vector<EdgeTriangle> FindIntersections(const Eigen::VectorXd& x,
                                            CollisionSurface<Planes>* surface);

struct ObstacleIntersections {
  std::vector<EdgeTriangle> cloth_edges;     // through the obstacle's triangles
  std::vector<EdgeTriangle> obstacle_edges;  // through the cloth's triangles
};
// The same between a cloth at x (3N, m) and an obstacle at y (3M, m).
template <int Planes>
ObstacleIntersections FindIntersections(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                        CollisionSurface<Planes>* cloth,
                                        CollisionSurface<Planes>* obstacle);

}  // namespace clothfit
