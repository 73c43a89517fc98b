// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/obstacle.h"

namespace clothfit {

std::vector<AreaElement> AreaElements(const TermContext& context) {
  std::vector<AreaElement> elements;
  for (int i = 0; i < context.mesh.num_particles(); ++i)
    elements.push_back({{i}, context.topology.areas[i]});
  return elements;
}

std::vector<ObstaclePlane::Element> ObstaclePlane::Elements(const TermContext& context) {
  const DownFrame frame = MakeDownFrame(context.world.gravity);
  std::vector<Element> elements;
  for (int i = 0; i < context.mesh.num_particles(); ++i)
    elements.push_back({{i}, context.topology.areas[i], frame});
  return elements;
}

}  // namespace clothfit
