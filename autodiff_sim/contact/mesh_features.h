// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The vertices, edges and triangles of a mesh, each vertex and edge owned by one triangle, so that
// going through pairs of triangles finds each pair of features once (Curtis, Tamstorf and Manocha
// 2008, "Fast collision detection for deformable models using representative-triangles").
#pragma once

#include <array>
#include <vector>

namespace clothfit {

// Up to three numbers.
struct OwnedFeatures {
  std::array<int, 3> indices = {-1, -1, -1};
  int count = 0;

  void Add(int index) { indices[count++] = index; }
  const int* begin() const { return indices.data(); }
  const int* end() const { return indices.data() + count; }
};

// Vertices are those of a cloth (its particles) or of an obstacle's mesh. A vertex without a
// triangle belongs to nobody and collides with nothing.
struct MeshFeatures {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> edges;      // each once, its smaller vertex first, sorted
  std::vector<OwnedFeatures> owned_vertices;  // per triangle
  std::vector<OwnedFeatures> owned_edges;     // per triangle

  bool EdgeHas(int edge, int vertex) const {
    return edges[edge][0] == vertex || edges[edge][1] == vertex;
  }
  bool TriangleHas(int triangle, int vertex) const {
    const std::array<int, 3>& t = triangles[triangle];
    return t[0] == vertex || t[1] == vertex || t[2] == vertex;
  }
  bool EdgesTouch(int a, int b) const { return EdgeHas(b, edges[a][0]) || EdgeHas(b, edges[a][1]); }
  bool EdgeTouchesTriangle(int edge, int triangle) const {
    return TriangleHas(triangle, edges[edge][0]) || TriangleHas(triangle, edges[edge][1]);
  }
};

// Any triangles, closed, with holes or with more than two at an edge; indices are 0 or more.
MeshFeatures FindFeatures(const std::vector<std::array<int, 3>>& triangles);

}  // namespace clothfit
