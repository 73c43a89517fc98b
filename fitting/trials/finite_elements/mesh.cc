// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/finite_elements/mesh.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace clothfit {

FemMesh MakeFemMesh(const Eigen::Vector2d& size, const Eigen::Vector2i& cells, std::uint64_t seed) {
  constexpr double kJitter = 0.2;  // of a cell
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  const Eigen::Vector2d cell = size.cwiseQuotient(cells.cast<double>());
  FemMesh mesh;
  for (int j = 0; j <= cells.y(); ++j) {
    for (int i = 0; i <= cells.x(); ++i) {
      Eigen::Vector2d at(i, j);
      const double du = kJitter * (2.0 * unit() - 1.0), dv = kJitter * (2.0 * unit() - 1.0);
      // Vertices of a side stay on it, the corners where they are.
      if (i > 0 && i < cells.x()) at.x() += du;
      if (j > 0 && j < cells.y()) at.y() += dv;
      mesh.uv.emplace_back(at.cwiseProduct(cell));
    }
  }
  const int row = cells.x() + 1;
  for (int j = 0; j < cells.y(); ++j) {
    for (int i = 0; i < cells.x(); ++i) {
      const int a = i + j * row, b = a + 1, c = b + row, d = a + row;
      if (unit() < 0.5) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

std::vector<FemLaplacian> LaplaciansOf(const FemMesh& mesh) {
  std::map<std::pair<int, int>, double> cotangents;  // summed, of the edge's two triangles
  std::map<std::pair<int, int>, int> triangles_at;   // of an edge
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const Eigen::Vector2d& tip = mesh.uv[t[(k + 2) % 3]];
      const Eigen::Vector2d to_a = mesh.uv[a] - tip, to_b = mesh.uv[b] - tip;
      const double cross = to_a.x() * to_b.y() - to_a.y() * to_b.x();
      cotangents[std::minmax(a, b)] += to_a.dot(to_b) / cross;
      ++triangles_at[std::minmax(a, b)];
    }
  }
  std::vector<FemLaplacian> all(mesh.uv.size());
  std::vector<bool> is_inside(mesh.uv.size(), true);
  for (const auto& [edge, cotangent] : cotangents) {
    const double weight = 0.5 * cotangent;
    const double length2 = (mesh.uv[edge.first] - mesh.uv[edge.second]).squaredNorm();
    for (const auto& [from, to] : {edge, std::make_pair(edge.second, edge.first)}) {
      FemLaplacian& laplacian = all[from];
      laplacian.weights.emplace_back(to, weight);
      laplacian.area += 0.25 * weight * length2;
      if (triangles_at[edge] < 2) is_inside[from] = false;
    }
  }
  std::vector<FemLaplacian> inside;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_inside[i]) continue;
    double sum = 0.0;
    for (const auto& [vertex, weight] : all[i].weights) sum += weight;
    all[i].weights.emplace_back(static_cast<int>(i), -sum);
    all[i].vertex = static_cast<int>(i);
    inside.push_back(std::move(all[i]));
  }
  return inside;
}

double TriangleArea(const FemMesh& mesh, const std::array<int, 3>& nodes) {
  const Eigen::Vector2d a = mesh.uv[nodes[1]] - mesh.uv[nodes[0]];
  const Eigen::Vector2d b = mesh.uv[nodes[2]] - mesh.uv[nodes[0]];
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

std::vector<double> VertexAreas(const FemMesh& mesh) {
  std::vector<double> areas(mesh.uv.size(), 0.0);
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (const int node : t) areas[node] += TriangleArea(mesh, t) / 3.0;
  }
  return areas;
}

}  // namespace clothfit
