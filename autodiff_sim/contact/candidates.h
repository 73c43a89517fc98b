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

#include <algorithm>

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// The three below are for what triangle_a of surface a owns against triangle_b of surface b.
// Features of one surface that have a vertex in common are left out, before their volumes are
// looked at.

// Calls visit(vertex) for the vertices that overlap triangle_b.
template <int Planes, class Visit>
void VisitVertices(const CollisionSurface<Planes>& a, int triangle_a,
                   const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  const bool same = &a == &b;
  for (const int vertex : a.features().owned_vertices[triangle_a]) {
    if (same && b.features().TriangleHas(triangle_b, vertex)) continue;
    if (a.vertex(vertex).Overlaps(b.triangle(triangle_b))) visit(vertex);
  }
}

// Calls visit(edge) for the edges that overlap triangle_b.
template <int Planes, class Visit>
void VisitEdges(const CollisionSurface<Planes>& a, int triangle_a,
                const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  const bool same = &a == &b;
  for (const int edge : a.features().owned_edges[triangle_a]) {
    if (same && b.features().EdgeTouchesTriangle(edge, triangle_b)) continue;
    if (a.edge(edge).Overlaps(b.triangle(triangle_b))) visit(edge);
  }
}

// Calls visit(edge of a, edge of b) for the edges of both that overlap.
template <int Planes, class Visit>
void VisitEdgePairs(const CollisionSurface<Planes>& a, int triangle_a,
                    const CollisionSurface<Planes>& b, int triangle_b, const Visit& visit) {
  const bool same = &a == &b;
  for (const int edge_a : a.features().owned_edges[triangle_a]) {
    for (const int edge_b : b.features().owned_edges[triangle_b]) {
      if (same && a.features().EdgesTouch(edge_a, edge_b)) continue;
      if (a.edge(edge_a).Overlaps(b.edge(edge_b))) visit(edge_a, edge_b);
    }
  }
}

// Calls visit(FeaturePair) once for each pair of features of the surface whose volumes overlap and
// that have no vertex in common, in no particular order.
template <int Planes, class Visit>
void VisitCandidates(const CollisionSurface<Planes>& surface, const Visit& visit) {
  const auto visit_vertices = [&](int a, int b) {
    VisitVertices(surface, a, surface, b, [&](int vertex) {
      visit(FeaturePair{PairKind::kVertexTriangle, vertex, b});
    });
  };
  surface.tree().VisitSelf([&](int a, int b) {
    visit_vertices(a, b);
    visit_vertices(b, a);
    VisitEdgePairs(surface, a, surface, b, [&](int e, int f) {
      visit(FeaturePair{PairKind::kEdgeEdge, std::min(e, f), std::max(e, f)});
    });
  });
}

// The same for a cloth and an obstacle, which have no vertices in common.
template <int Planes, class Visit>
void VisitCandidates(const CollisionSurface<Planes>& cloth,
                     const CollisionSurface<Planes>& obstacle, const Visit& visit) {
  cloth.tree().VisitPairs(obstacle.tree(), [&](int a, int b) {
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
