// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Simulates stretches of a scene for given free parameters, with derivatives.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <utility>

#include "autodiff_sim/step/known_motion.h"
#include "autodiff_sim/step/simulation.h"
#include "fitting/rollout/attraction_targets.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// How the config wants steps to be made.
SimulationOptions StepOptions(const FitConfig& config);

// A state at a frame, as a function of theta to first order around the theta it was reached with.
struct WindowStart {
  int frame = 0;
  State state;
  Sensitivity sensitivity;  // directions = the free vector
  Eigen::VectorXd theta;
};

class WindowSimulator {
 public:
  enum class Outcome { kComplete, kDiverged, kStopped };
  // Called for a window's every frame; `sensitivity` is null without derivatives.
  using Observer =
      std::function<void(int frame, const State& state, const Sensitivity* sensitivity)>;

  // attract: fitted markers and tracks' rays pull on the cloth, on their courses, with
  // attraction_point.* and attraction_ray.* while it is simulated.
  WindowSimulator(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                  bool attract, const std::atomic<bool>* stop);

  // The start of the recording.
  WindowStart FirstStart(const Eigen::VectorXd& theta) const;

  // Simulates the frames after start.frame up to last_frame, calling observer(start.frame, ...)
  // first. `end`, where given, gets the state at last_frame to go on from (with derivatives only).
  // A motion that was simulated last without derivatives is not solved for again with them.
  Outcome Run(const WindowStart& start, const Eigen::VectorXd& theta, int last_frame,
              bool derivatives, const Observer& observer, WindowStart* end = nullptr);

  // Of several stretches in turns: each keeps its own motion.
  void SwapMotion(KnownMotion* other) { std::swap(motion_, *other); }

  // Entries of the free vector, handles' only, along which nothing is differentiated from here on.
  void Hold(const std::vector<int>& entries) { held_ = entries; }

  const Simulation& simulation() const { return simulation_; }
  const ClothMesh& mesh() const { return scene_.mesh; }
  double simulated_frames() const { return simulated_frames_; }
  // Those that had derivatives, each as the share of the directions that had moved anything; where
  // the motion was known already they are not counted among the others.
  double differentiated_frames() const { return differentiated_frames_; }
  const StepReport& last_report() const { return report_; }

 private:
  StepInputs Inputs(double time, bool with_directions) const;

  const Scene& scene_;
  const FreeParameters& free_;
  std::optional<AttractionCourses> attracting_;
  const std::atomic<bool>* stop_;
  Simulation simulation_;
  std::vector<SceneHandle> handles_;
  std::vector<int> held_;
  double simulated_frames_ = 0.0, differentiated_frames_ = 0.0;
  StepReport report_;
  KnownMotion motion_;  // simulated last without derivatives
};

}  // namespace clothfit
