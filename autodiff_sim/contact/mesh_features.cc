// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/mesh_features.h"

#include <algorithm>

namespace clothfit {
namespace {

std::array<int, 2> Side(const std::array<int, 3>& triangle, int k) {
  const int a = triangle[k], b = triangle[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

// The first triangle that has a feature owns it.
void Claim(int feature, std::vector<bool>* claimed, OwnedFeatures* owned) {
  if ((*claimed)[feature]) return;
  (*claimed)[feature] = true;
  owned->Add(feature);
}

}  // namespace

MeshFeatures FindFeatures(const std::vector<std::array<int, 3>>& triangles) {
  MeshFeatures features;
  features.triangles = triangles;
  std::vector<std::array<int, 2>>& edges = features.edges;
  int num_vertices = 0;
  for (const std::array<int, 3>& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      edges.push_back(Side(triangle, k));
      num_vertices = std::max(num_vertices, triangle[k] + 1);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  features.owned_vertices.resize(triangles.size());
  features.owned_edges.resize(triangles.size());
  std::vector<bool> vertex_claimed(num_vertices), edge_claimed(edges.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto edge = std::lower_bound(edges.begin(), edges.end(), Side(triangles[i], k));
      Claim(triangles[i][k], &vertex_claimed, &features.owned_vertices[i]);
      Claim(static_cast<int>(edge - edges.begin()), &edge_claimed, &features.owned_edges[i]);
    }
  }
  return features;
}

}  // namespace clothfit
