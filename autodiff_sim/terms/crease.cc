// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/crease.h"

namespace clothfit {

std::vector<Crease::Element> Crease::Elements(const TermContext& context) {
  const Eigen::Vector2d middle = MiddleOfCloth(context.mesh);
  std::vector<Element> elements;
  for (const Hinge& hinge : context.topology.hinges) {
    Element element = {hinge.nodes, hinge.shape, {}, {}};
    std::array<Eigen::Vector3d, 4> flat;
    for (int i = 0; i < kNodes; ++i) {
      element.from_middle[i] = context.mesh.uv[hinge.nodes[i]] - middle;
      flat[i] << element.from_middle[i], 0.0;
    }
    // Minus the gradient of the angle, and a fold that rises along the normal has a negative one.
    const std::array<Eigen::Vector3d, 4> mode = FlatteningMode<double>(MakeFold<double>(flat));
    for (int i = 0; i < kNodes; ++i) element.angle_of_height[i] = -mode[i].z();
    elements.push_back(element);
  }
  return elements;
}

}  // namespace clothfit
