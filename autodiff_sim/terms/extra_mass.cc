// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/extra_mass.h"

#include <algorithm>
#include <map>
#include <utility>

namespace clothfit {

std::vector<Hem::Element> Hem::Elements(const TermContext& context) {
  const ClothMesh& mesh = context.mesh;
  std::map<std::pair<int, int>, int> triangles;  // at each edge
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++triangles[std::minmax(t[k], t[(k + 1) % 3])];
  }
  std::map<int, std::array<double, 4>> lengths;
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (triangles.at(std::minmax(a, b)) != 1) continue;
      // Triangles run counter-clockwise: outside is to the right.
      const Eigen::Vector2d edge = mesh.uv[b] - mesh.uv[a];
      const double length = edge.norm(), u = edge.y() / length, v = -edge.x() / length;
      for (const int node : {a, b}) {
        lengths[node][u > 0.0 ? 1 : 0] += 0.5 * length * u * u;
        lengths[node][v > 0.0 ? 3 : 2] += 0.5 * length * v * v;
      }
    }
  }
  const Eigen::Vector3d& gravity = context.world.gravity;
  std::vector<Element> elements;
  for (const auto& [node, length] : lengths)
    elements.push_back({{node}, length, gravity.norm(), MakeDownFrame(gravity)});
  return elements;
}

std::vector<HeavyPatch::Element> HeavyPatch::Elements(const TermContext& context) {
  const Eigen::Vector3d& gravity = context.world.gravity;
  std::vector<Element> elements;
  for (int i = 0; i < context.mesh.num_particles(); ++i) {
    elements.push_back({{i},
                        context.topology.areas[i],
                        context.mesh.uv[i],
                        gravity.norm(),
                        MakeDownFrame(gravity)});
  }
  return elements;
}

}  // namespace clothfit
