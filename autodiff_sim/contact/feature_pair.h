// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A pair of features that may collide: of one surface, or of a cloth and an obstacle.
#pragma once

#include <array>
#include <tuple>

#include <Eigen/Core>

#include "autodiff_sim/contact/closest_points.h"
#include "autodiff_sim/contact/mesh_features.h"

namespace clothfit {

enum class PairKind {
  kVertexTriangle,  // first a vertex of the cloth, second a triangle of the obstacle
  kTriangleVertex,  // first a triangle of the cloth, second a vertex of the obstacle
  kEdgeEdge,        // an edge of each
};

// Edges and triangles are numbered as in MeshFeatures. Within one surface both features are of that
// surface, there is no kTriangleVertex, and of two edges the first has the smaller number.
struct FeaturePair {
  PairKind kind;
  int first;
  int second;
};
inline bool operator<(const FeaturePair& a, const FeaturePair& b) {
  return std::tie(a.kind, a.first, a.second) < std::tie(b.kind, b.first, b.second);
}
inline bool operator==(const FeaturePair& a, const FeaturePair& b) {
  return a.kind == b.kind && a.first == b.first && a.second == b.second;
}

// The four vertices of a pair: the vertex and then the triangle's three, or the first edge's two
// and then the second's.
inline std::array<int, 4> PairVertices(const FeaturePair& pair, const MeshFeatures& cloth,
                                       const MeshFeatures& obstacle) {
  if (pair.kind == PairKind::kEdgeEdge) {
    const std::array<int, 2>&e = cloth.edges[pair.first], &f = obstacle.edges[pair.second];
    return {e[0], e[1], f[0], f[1]};
  }
  const bool turned = pair.kind == PairKind::kTriangleVertex;
  const std::array<int, 3>& t =
      turned ? cloth.triangles[pair.first] : obstacle.triangles[pair.second];
  return {turned ? pair.second : pair.first, t[0], t[1], t[2]};
}

// Their places. A mesh and where it is; both must outlive this.
struct PlacedMesh {
  const MeshFeatures& features;
  const Eigen::VectorXd& x;  // 3N, m
};
inline FourPoints PairPoints(const FeaturePair& pair, const PlacedMesh& cloth,
                             const PlacedMesh& obstacle) {
  const std::array<int, 4> vertices = PairVertices(pair, cloth.features, obstacle.features);
  const int from_cloth = pair.kind == PairKind::kEdgeEdge ? 2 : 1;
  FourPoints points;
  for (int i = 0; i < 4; ++i) {
    const bool of_cloth = (i < from_cloth) != (pair.kind == PairKind::kTriangleVertex);
    points[i] = (of_cloth ? cloth.x : obstacle.x).segment<3>(3 * vertices[i]);
  }
  return points;
}

}  // namespace clothfit
