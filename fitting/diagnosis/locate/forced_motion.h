// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted scene simulated with a given force on the cloth besides, and differentiated by the
// fit's free entries and by that force.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "autodiff_sim/step/simulation.h"
#include "fitting/diagnosis/locate/force_layout.h"
#include "fitting/rollout/attraction_targets.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/scene.h"

namespace clothfit {

class ForcedMotion {
 public:
  // Called for every frame from 0 on; `sensitivity` is null without derivatives.
  using Observer =
      std::function<void(int frame, const State& state, const Sensitivity* sensitivity)>;

  // The arguments must outlive this object. What was observed pulls at the cloth where the config
  // says so (IsNudged). `stop`, which may be null, ends a run.
  ForcedMotion(const Scene& scene, const FitConfig& config, const FreeParameters& free,
               const ForceLayout& layout, const std::atomic<bool>* stop = nullptr);

  // Directions: the free entries, some that nothing moves, and from first_control() on the force's
  // numbers, so that those of one knot share blocks of lanes, which sleep until it begins.
  int first_control() const { return first_control_; }
  int num_directions() const { return first_control_ + layout_.size(); }

  // Open loop, frames 0 to last_frame, of the force (N/m^2, layout.size()). False where the
  // simulation does not get there or is stopped.
  bool Run(const Eigen::VectorXd& theta, const Eigen::VectorXd& force, int last_frame,
           bool derivatives, const Observer& observer);

 private:
  State FirstState(const Eigen::VectorXd& theta) const;
  Sensitivity FirstSensitivity(const State& state, const Eigen::VectorXd& theta) const;
  StepInputs Inputs(const Eigen::VectorXd& force, double time, bool with_directions) const;

  const Scene& scene_;
  const FreeParameters& free_;
  const ForceLayout& layout_;
  const std::atomic<bool>* stop_;
  int first_control_;
  int share_;  // index of residual_force.share
  Simulation simulation_;
  std::vector<SceneHandle> handles_;
  std::optional<AttractionCourses> attracting_;
};

}  // namespace clothfit
