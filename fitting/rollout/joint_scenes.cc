// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/joint_scenes.h"

#include <algorithm>
#include <utility>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/shared_parameters.h"

namespace clothfit {

JointScenes::JointScenes(std::vector<NamedScene> scenes) : scenes_(std::move(scenes)) {
  const bool are_several = scenes_.size() > 1;
  parts_.reserve(scenes_.size());
  for (const auto& [name, scene, config] : scenes_) {
    parts_.push_back({*scene, *config, FreeParameters(*config, *scene, MakeParameterTable()),
                      ObservationResiduals(*scene, *config)});
    const FreeParameters& free = parts_.back().free;
    std::vector<bool> is_shared;
    for (const FreeEntry& entry : free.entries())
      is_shared.push_back(entry.kind == FreeEntry::Kind::kParameter &&
                          IsShared(*config, entry.name));
    free_.Add(are_several ? name : "", free, is_shared);
  }
}

int JointScenes::LastFittedFrame() const {
  int last = 0;
  for (const Part& part : parts_) last = std::max(last, part.scene.last_fitted_frame);
  return last;
}

int JointScenes::NumObserved(int last) const {
  int count = 0;
  for (const Part& part : parts_)
    count += part.observations.NumObserved(0, std::min(last, part.scene.last_fitted_frame));
  return count;
}

int JointScenes::NumResiduals() const {
  int count = 0;
  for (const Part& part : parts_) count += part.observations.Count(0, part.scene.last_fitted_frame);
  return count;
}

int JointScenes::NumFittedFrames() const {
  int count = 0;
  for (const Part& part : parts_) count += part.scene.last_fitted_frame;
  return std::max(1, count);
}

}  // namespace clothfit
