// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All pairs of features of one or two meshes: what the trees are tested and measured against.
#pragma once

#include <algorithm>

#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// Calls visit(FeaturePair) for all pairs of one mesh that have no vertex in common.
template <class Visit>
void VisitAllPairs(const MeshFeatures& mesh, int num_vertices, const Visit& visit) {
  const int num_triangles = static_cast<int>(mesh.triangles.size());
  const int num_edges = static_cast<int>(mesh.edges.size());
  for (int v = 0; v < num_vertices; ++v) {
    for (int t = 0; t < num_triangles; ++t) {
      if (!mesh.TriangleHas(t, v)) visit(FeaturePair{PairKind::kVertexTriangle, v, t});
    }
  }
  for (int e = 0; e < num_edges; ++e) {
    for (int f = e + 1; f < num_edges; ++f) {
      if (!mesh.EdgesTouch(e, f)) visit(FeaturePair{PairKind::kEdgeEdge, e, f});
    }
  }
}

// The same for two meshes of these numbers of vertices.
template <class Visit>
void VisitAllPairs(const MeshFeatures& a, int vertices_a, const MeshFeatures& b, int vertices_b,
                   const Visit& visit) {
  for (int v = 0; v < vertices_a; ++v) {
    for (int t = 0; t < static_cast<int>(b.triangles.size()); ++t) {
      visit(FeaturePair{PairKind::kVertexTriangle, v, t});
    }
  }
  for (int t = 0; t < static_cast<int>(a.triangles.size()); ++t) {
    for (int v = 0; v < vertices_b; ++v) visit(FeaturePair{PairKind::kTriangleVertex, t, v});
  }
  for (int e = 0; e < static_cast<int>(a.edges.size()); ++e) {
    for (int f = 0; f < static_cast<int>(b.edges.size()); ++f) {
      visit(FeaturePair{PairKind::kEdgeEdge, e, f});
    }
  }
}

}  // namespace clothfit
