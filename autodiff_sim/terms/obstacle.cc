// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/obstacle.h"

#include "autodiff_sim/term/force_batch_impl.h"

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

template std::unique_ptr<ForceBatch> MakeForceBatch<ObstaclePlane>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<ObstacleSphere>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<ObstacleCapsule>(const TermContext&);

}  // namespace clothfit
