// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The pairs of features that a query has to look at: those whose volumes overlap.
//
// There is no cull by the cone of normals (Volino and Magnenat-Thalmann 1994; Provot 1997). It says
// that a patch does not pass through itself, not that no two of its features are near each other;
// and it holds only where the patch's boundary does not cross itself either, over the whole step if
// the patch moves.
#pragma once

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

template <int Planes>
Dop<Planes> EdgeVolume(const CollisionSurface<Planes>& surface, int edge) {
  const std::array<int, 2>& ends = surface.features.edges[edge];
  Dop<Planes> volume = surface.tree.vertex(ends[0]);
  volume.Merge(surface.tree.vertex(ends[1]));
  return volume;
}

// Calls visit(vertex of a) for the vertices that a triangle of a owns and that overlap one of b.
template <int Planes, class Visit>
void VisitVertices(const CollisionSurface<Planes>& a, int triangle_a,
                   const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  const Dop<Planes>& volume_b = b.tree.triangle(triangle_b);
  for (const int vertex : a.features.owned_vertices[triangle_a]) {
    if (a.tree.vertex(vertex).Overlaps(volume_b)) visit(vertex);
  }
}

// Calls visit(edge of a) in the same way.
template <int Planes, class Visit>
void VisitEdges(const CollisionSurface<Planes>& a, int triangle_a,
                const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  const Dop<Planes>& volume_b = b.tree.triangle(triangle_b);
  for (const int edge : a.features.owned_edges[triangle_a]) {
    if (EdgeVolume(a, edge).Overlaps(volume_b)) visit(edge);
  }
}

// Calls visit(edge of a, edge of b) for edges that the triangles own and that overlap.
template <int Planes, class Visit>
void VisitEdgePairs(const CollisionSurface<Planes>& a, int triangle_a,
                    const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  VisitEdges(a, triangle_a, b, triangle_b, [&](int edge_a) {
    const Dop<Planes> volume_a = EdgeVolume(a, edge_a);
    for (const int edge_b : b.features.owned_edges[triangle_b]) {
      if (volume_a.Overlaps(EdgeVolume(b, edge_b))) visit(edge_a, edge_b);
    }
  });
}

// Calls visit(FeaturePair) once for each pair of features of the surface whose volumes overlap and
// that have no vertex in common, in no particular order.
template <int Planes, class Visit>
void VisitCandidates(const CollisionSurface<Planes>& surface, const Visit& visit) {
  const MeshFeatures& features = surface.features;
  const auto visit_vertices = [&](int a, int b) {
    VisitVertices(surface, a, surface, b, [&](int vertex) {
      if (features.TriangleHas(b, vertex)) return;
      visit(FeaturePair{PairKind::kVertexTriangle, vertex, b});
    });
  };
  surface.tree.VisitSelf([&](int a, int b) {
    visit_vertices(a, b);
    visit_vertices(b, a);
    VisitEdgePairs(surface, a, surface, b, [&](int e, int f) {
      if (features.EdgesTouch(e, f)) return;
      visit(FeaturePair{PairKind::kEdgeEdge, std::min(e, f), std::max(e, f)});
    });
  });
}

// The same for a cloth and an obstacle, which have no vertices in common.
template <int Planes, class Visit>
void VisitCandidates(const CollisionSurface<Planes>& cloth,
                     const CollisionSurface<Planes>& obstacle, const Visit& visit) {
  cloth.tree.VisitPairs(obstacle.tree, [&](int a, int b) {
    VisitVertices(cloth, a, obstacle, b, [&](int vertex) {
      visit(FeaturePair{PairKind::kVertexTriangle, vertex, b});
    });
    VisitVertices(obstacle, b, cloth, a, [&](int vertex) {
      visit(FeaturePair{PairKind::kTriangleVertex, a, vertex});
    });
    VisitEdgePairs(cloth, a, obstacle, b, [&](int e, int f) {
      visit(FeaturePair{PairKind::kEdgeEdge, e, f});
    });
  });
}

}  // namespace clothfit
