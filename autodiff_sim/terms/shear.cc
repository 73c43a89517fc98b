// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/shear.h"

namespace clothfit {

// Two at a time where they cross in a cell of a grid, whose two follow one another.
std::vector<Shear::Element> Shear::Elements(const TermContext& context) {
  const std::vector<Spring>& springs = context.topology.shear;
  std::vector<Element> elements;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const auto [a, b] = springs[i].nodes;
    Element element = {{a, b, b, b}, 1, {springs[i], {}}};
    if (context.mesh.is_grid()) {
      const Spring& other = springs[++i];
      element = {{a, b, other.nodes[0], other.nodes[1]}, 2, {springs[i - 1], other}};
    }
    elements.push_back(element);
  }
  return elements;
}

double Shear::Energy(const Element& element, const ElementInput<Shear, double>& in) {
  double energy = 0.0;
  for (int i = 0; i < element.springs; ++i) {
    const Eigen::Vector3d dx = in.x[2 * i + 1] - in.x[2 * i];
    energy += SpringEnergy(element.bias[i], {in.parameter[0], 0.0, in.read[0]}, in.shrinkage, dx);
  }
  return energy;
}

}  // namespace clothfit
