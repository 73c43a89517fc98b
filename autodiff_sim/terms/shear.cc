// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/shear.h"

namespace clothfit {
namespace {

Shear::Element CellOf(const ClothMesh& mesh, int i, int j) {
  const int nu = mesh.grid[0], a = i + j * nu, d = a + nu + 1;
  const Eigen::Vector2d size = mesh.uv[d] - mesh.uv[a];
  const double area = size.x() * size.y(), u = 0.5 / size.x(), v = 0.5 / size.y();
  return {{a, a + 1, a + nu, d}, area, std::sqrt(area), {-u, u, -u, u}, {-v, -v, v, v}, 0, {}};
}

Shear::Element TriangleOf(const ShearTriangle& t) {
  const auto [a, b, c] = t.nodes;
  Shear::Element element = {{a, b, c, c}, t.area, std::sqrt(2.0 * t.area), {}, {}, 0, {}};
  for (int i = 0; i < 3; ++i) {
    element.du[i] = t.du[i];
    element.dv[i] = t.dv[i];
  }
  return element;
}

// The springs along the bias, two at a time where they cross in a cell.
std::vector<Shear::Element> BiasSprings(const ClothMesh& mesh, const std::vector<Spring>& springs) {
  std::vector<Shear::Element> elements;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const auto [a, b] = springs[i].nodes;
    Shear::Element element = {{a, b, b, b}, 0.0, 0.0, {}, {}, 1, {springs[i], {}}};
    if (mesh.is_grid()) {  // where each cell's two follow one another
      const Spring& other = springs[++i];
      element.nodes = {a, b, other.nodes[0], other.nodes[1]};
      element.springs = 2;
      element.bias[1] = other;
    }
    elements.push_back(element);
  }
  return elements;
}

}  // namespace

std::vector<Shear::Element> Shear::Elements(const TermContext& context) {
  const ClothMesh& mesh = context.mesh;
  if (!mesh.buckles) return BiasSprings(mesh, context.topology.shear);
  std::vector<Element> elements;
  if (mesh.is_grid()) {
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
  if (element.length == 0.0) {
    double energy = 0.0;
    for (int i = 0; i < element.springs; ++i) {
      const Eigen::Vector3d dx = in.x[2 * i + 1] - in.x[2 * i];
      energy += SpringEnergy(element.bias[i], {shear, 0.0, 0.0}, in.shrinkage, dx);
    }
    return energy;
  }
  const Eigen::Vector3d u = AlongCloth<double>(element.du, in.x) / (1.0 - in.shrinkage[0]);
  const Eigen::Vector3d v = AlongCloth<double>(element.dv, in.x) / (1.0 - in.shrinkage[1]);
  const PlaneStress<double> strain = {u.norm() - 1.0, v.norm() - 1.0, u.dot(v)};
  if (in.read[0] <= 0.0) return 0.5 * shear * strain[2] * strain[2] * element.area;
  const std::array<double, 2> stretch = Stretch<double>(in);
  const double load = BucklingLoad(in.read[2], in.read[0], element.length);
  return (BuckledEnergy({stretch[0], stretch[1], shear}, load, strain) -
          BuckledEnergy(stretch[0], load, strain[0]) - BuckledEnergy(stretch[1], load, strain[1])) *
         element.area;
}

}  // namespace clothfit
