// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/finite_elements/fem_mesh.h"

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

std::vector<FemHinge> HingesOf(const FemMesh& mesh) {
  std::map<std::pair<int, int>, int> opposite;  // of a directed edge
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) opposite[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  }
  std::vector<FemHinge> hinges;
  for (const auto& [edge, left] : opposite) {
    const auto other = opposite.find({edge.second, edge.first});
    if (edge.first < edge.second && other != opposite.end())
      hinges.push_back({{edge.first, edge.second, left, other->second}});
  }
  return hinges;
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
