// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/adhesion.h"

namespace clothfit {

std::vector<GroundElement> GroundElements(const TermContext& context) {
  std::vector<GroundElement> elements;
  if (!context.world.ground_height) return elements;
  for (int i = 0; i < context.mesh.num_particles(); ++i) {
    elements.push_back(
        {{i}, context.topology.areas[i], *context.world.ground_height, context.mesh.uv[i]});
  }
  return elements;
}

}  // namespace clothfit
