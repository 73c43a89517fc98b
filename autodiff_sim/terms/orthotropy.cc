// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/orthotropy.h"

namespace clothfit {

std::vector<StretchOrthotropy::Element> StretchOrthotropy::Elements(const TermContext& context) {
  std::vector<Element> elements;
  for (const Spring& spring : context.topology.structural)
    elements.push_back({spring.nodes, spring, spring.warp_share - 0.5});
  return elements;
}

std::vector<ShearOrthotropy::Element> ShearOrthotropy::Elements(const TermContext& context) {
  std::vector<Element> elements;
  for (const BiasSprings& springs : PairBiasSprings(context)) {
    Element element = {springs.nodes, springs, {}};
    for (int i = 0; i < springs.springs; ++i) {
      const std::array<int, 2>& nodes = springs.bias[i].nodes;
      const Eigen::Vector2d along = context.mesh.uv[nodes[1]] - context.mesh.uv[nodes[0]];
      // Half the sine of twice the angle to the warp: 1/2 on one bias and -1/2 on the other.
      element.exponent[i] = along.x() * along.y() / along.squaredNorm();
    }
    elements.push_back(element);
  }
  return elements;
}

std::vector<BendingOrthotropy::Element> BendingOrthotropy::Elements(const TermContext& context) {
  std::vector<Element> elements;
  for (const Hinge& hinge : context.topology.hinges) {
    const Eigen::Vector2d edge = context.mesh.uv[hinge.nodes[3]] - context.mesh.uv[hinge.nodes[2]];
    // It bends across its edge.
    elements.push_back({hinge.nodes, hinge, edge.y() * edge.y() / edge.squaredNorm() - 0.5});
  }
  return elements;
}

}  // namespace clothfit
