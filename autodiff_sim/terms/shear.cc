// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/shear.h"

#include "autodiff_sim/term/shear_strain.h"

namespace clothfit {
namespace {

Shear::Element CellOf(const ClothMesh& mesh, int i, int j) {
  const int nu = mesh.grid[0], a = i + j * nu, d = a + nu + 1;
  const Eigen::Vector2d size = mesh.uv[d] - mesh.uv[a];
  const double area = size.x() * size.y(), u = 0.5 / size.x(), v = 0.5 / size.y();
  return {{a, a + 1, a + nu, d}, area, std::sqrt(area), {-u, u, -u, u}, {-v, -v, v, v}, {}};
}

Shear::Element TriangleOf(const ShearTriangle& t) {
  Shear::Element element = {{t.nodes[0], t.nodes[1], t.nodes[2], t.nodes[2]},
                            t.area,
                            std::sqrt(2.0 * t.area),
                            {},
                            {},
                            {}};
  for (int i = 0; i < 3; ++i) {
    element.du[i] = t.du[i];
    element.dv[i] = t.dv[i];
  }
  return element;
}

Shear::Element SpringOf(const Spring& spring) {
  const auto [a, b] = spring.nodes;
  return {{a, b, b, b}, 0.0, 0.0, {}, {}, spring};
}

}  // namespace

std::vector<Shear::Element> Shear::Elements(const TermContext& context) {
  const ClothMesh& mesh = context.mesh;
  std::vector<Element> elements;
  if (!mesh.buckles) {
    for (const Spring& spring : context.topology.shear) elements.push_back(SpringOf(spring));
  } else if (mesh.is_grid()) {
    for (int j = 0; j + 1 < mesh.grid[1]; ++j) {
      for (int i = 0; i + 1 < mesh.grid[0]; ++i) elements.push_back(CellOf(mesh, i, j));
    }
  } else {
    for (const ShearTriangle& triangle : ShearTriangles(mesh))
      elements.push_back(TriangleOf(triangle));
  }
  return elements;
}

double Shear::Energy(const Element& element, const ElementInput<Shear, double>& in) {
  const double shear = in.parameter[0];
  if (element.length == 0.0)
    return SpringEnergy(element.bias, {shear, 0.0, 0.0}, in.shrinkage, in.x[1] - in.x[0]);
  const Eigen::Vector3d u = Along<double>(element.du, 1.0 / (1.0 - in.shrinkage[0]), in.x);
  const Eigen::Vector3d v = Along<double>(element.dv, 1.0 / (1.0 - in.shrinkage[1]), in.x);
  const PlaneStress<double> strain = {u.norm() - 1.0, v.norm() - 1.0, u.dot(v)};
  if (in.read[0] <= 0.0) return 0.5 * shear * strain[2] * strain[2] * element.area;
  const std::array<double, 2> stretch = Stretch<double>(in);
  const double load = BucklingLoad(in.read[2], in.read[0], element.length);
  return (BuckledEnergy({stretch[0], stretch[1], shear}, load, strain) -
          BuckledEnergy(stretch[0], load, strain[0]) - BuckledEnergy(stretch[1], load, strain[1])) *
         element.area;
}

}  // namespace clothfit
