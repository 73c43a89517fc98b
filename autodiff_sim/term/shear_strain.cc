// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The triangles' shape functions.
#include "autodiff_sim/term/shear_strain.h"

namespace clothfit {

std::vector<ShearTriangle> ShearTriangles(const ClothMesh& mesh) {
  std::vector<ShearTriangle> triangles;
  for (const RestTriangle& rest : RestTriangles(mesh)) {
    ShearTriangle triangle = {rest.nodes, rest.area, {}, {}};
    const double scale = 0.5 / SignedArea(mesh, rest.nodes);
    for (int i = 0; i < 3; ++i) {
      // The side opposite to corner i, across which its shape function falls to zero.
      const Eigen::Vector2d side =
          mesh.uv[rest.nodes[(i + 2) % 3]] - mesh.uv[rest.nodes[(i + 1) % 3]];
      triangle.du[i] = -side.y() * scale;
      triangle.dv[i] = side.x() * scale;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace clothfit
