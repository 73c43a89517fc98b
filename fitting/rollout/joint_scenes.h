// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings of one cloth that are fitted together, one or more.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fitting/residuals/observation_residuals.h"
#include "fitting/rollout/joint_vector.h"

namespace clothfit {

struct NamedScene {
  std::string name;
  const Scene* scene;
  const FitConfig* config;
};

class JointScenes {
 public:
  struct Part {
    const Scene& scene;
    const FitConfig& config;
    FreeParameters free;
    ObservationResiduals observations;
  };

  // One or more; they must outlive it. Names tell own entries apart where there are several.
  explicit JointScenes(std::vector<NamedScene> scenes);

  std::size_t size() const { return parts_.size(); }
  const Part& operator[](std::size_t i) const { return parts_[i]; }
  const NamedScene& named(std::size_t i) const { return scenes_[i]; }
  const std::vector<NamedScene>& scenes() const { return scenes_; }
  const JointVector& free() const { return free_; }

  int LastFittedFrame() const;  // of the longest
  // Of all fitted frames, or those up to `last`: observed coordinates, and residuals.
  int NumObserved(int last = std::numeric_limits<int>::max()) const;
  int NumResiduals() const;
  // Frames that one simulation of each takes, 1 at least.
  int NumFittedFrames() const;

 private:
  std::vector<NamedScene> scenes_;
  std::vector<Part> parts_;
  JointVector free_;
};

}  // namespace clothfit
