// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/intersections.h"

#include <algorithm>

#include "autodiff_sim/contact/candidates.h"
#include "autodiff_sim/contact/edge_triangle_intersection.h"

namespace clothfit {
namespace {

bool Meet(const PlacedMesh& a, int edge, const PlacedMesh& b, int triangle) {
  const std::array<int, 2>& e = a.features.edges[edge];
  const std::array<int, 3>& t = b.features.triangles[triangle];
  return EdgeMeetsTriangle(
      {a.x.segment<3>(3 * e[0]), a.x.segment<3>(3 * e[1])},
      {b.x.segment<3>(3 * t[0]), b.x.segment<3>(3 * t[1]), b.x.segment<3>(3 * t[2])});
}

}  // namespace

template <int Planes>
std::vector<EdgeTriangle> FindIntersections(const Eigen::VectorXd& x,
                                            CollisionSurface<Planes>* surface) {
  surface->Refit(x, 0.0);
  const PlacedMesh mesh{surface->features(), x};
  std::vector<EdgeTriangle> found;
  const auto visit_edges = [&](int a, int b) {
    VisitEdges(*surface, a, *surface, b, [&](int edge) {
      if (Meet(mesh, edge, mesh, b)) found.push_back({edge, b});
    });
  };
  surface->tree().VisitSelf([&](int a, int b) {
    visit_edges(a, b);
    visit_edges(b, a);
  });
  std::sort(found.begin(), found.end());
  return found;
}

template <int Planes>
ObstacleIntersections FindIntersections(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                        CollisionSurface<Planes>* cloth,
                                        CollisionSurface<Planes>* obstacle) {
  cloth->Refit(x, 0.0);
  obstacle->Refit(y, 0.0);
  const PlacedMesh a{cloth->features(), x}, b{obstacle->features(), y};
  ObstacleIntersections found;
  cloth->tree().VisitPairs(obstacle->tree(), [&](int triangle_a, int triangle_b) {
    VisitEdges(*cloth, triangle_a, *obstacle, triangle_b, [&](int edge) {
      if (Meet(a, edge, b, triangle_b)) found.cloth_edges.push_back({edge, triangle_b});
    });
    VisitEdges(*obstacle, triangle_b, *cloth, triangle_a, [&](int edge) {
      if (Meet(b, edge, a, triangle_a)) found.obstacle_edges.push_back({edge, triangle_a});
    });
  });
  std::sort(found.cloth_edges.begin(), found.cloth_edges.end());
  std::sort(found.obstacle_edges.begin(), found.obstacle_edges.end());
  return found;
}

#define CLOTHFIT_INSTANTIATE(PLANES)                                                               \
  template std::vector<EdgeTriangle> FindIntersections(const Eigen::VectorXd&,                     \
                                                       CollisionSurface<PLANES>*);                 \
  template ObstacleIntersections FindIntersections(const Eigen::VectorXd&, const Eigen::VectorXd&, \
                                                   CollisionSurface<PLANES>*,                      \
                                                   CollisionSurface<PLANES>*)
CLOTHFIT_INSTANTIATE(6);
CLOTHFIT_INSTANTIATE(14);
CLOTHFIT_INSTANTIATE(18);
CLOTHFIT_INSTANTIATE(26);
#undef CLOTHFIT_INSTANTIATE

}  // namespace clothfit
