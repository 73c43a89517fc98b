// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/attraction_targets.h"

#include <algorithm>

namespace clothfit {

void AddAttractionTargets(const Scene& scene, int frame, StepInputs* inputs) {
  const auto before = [](const auto& observation, int f) { return observation.frame < f; };
  auto marker = std::lower_bound(scene.markers.begin(), scene.markers.end(), frame, before);
  for (; marker != scene.markers.end() && marker->frame == frame && scene.is_fitted[frame];
       ++marker) {
    inputs->points.push_back({marker->on_cloth, marker->position});
  }
  auto track = std::lower_bound(scene.tracks.begin(), scene.tracks.end(), frame, before);
  for (; track != scene.tracks.end() && track->frame == frame; ++track) {
    if (scene.IsFitted(*track) && track->ray)
      inputs->rays.push_back({track->on_cloth, track->ray->direction, track->ray->moment});
  }
}

}  // namespace clothfit
