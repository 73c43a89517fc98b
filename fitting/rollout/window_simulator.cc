// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One stretch of simulation.
#include "fitting/rollout/window_simulator.h"

#include <algorithm>

namespace clothfit {

SimulationOptions StepOptions(const FitConfig& config) {
  SimulationOptions options;
  options.integrator = config.integrator;
  options.tolerance = config.tolerance;
  options.num_threads = 0;
  options.self_contact = config.self_contact;
  options.check_intersections = config.check_intersections;
  return options;
}

WindowSimulator::WindowSimulator(const Scene& scene, const FitConfig& config,
                                 const FreeParameters& free, bool attract,
                                 const std::atomic<bool>* stop)
    : scene_(scene),
      free_(free),
      stop_(stop),
      simulation_(scene.mesh, scene.world, scene.HandlePoints(), StepOptions(config)),
      handles_(scene.handles) {
  if (attract) attracting_.emplace(scene);
}

WindowStart WindowSimulator::FirstStart(const Eigen::VectorXd& theta) const {
  WindowStart start;
  Eigen::VectorXd x, v;
  free_.InitialState(theta, &x, &v);
  start.state = simulation_.MakeState(x);
  start.state.v = v;
  start.theta = theta;
  start.sensitivity = Sensitivity(start.state, free_.ValueDirections(theta));
  Eigen::MatrixXd dx, dv;
  free_.InitialDirections(&dx, &dv);
  start.sensitivity.SetInitial(dx, dv);
  return start;
}

StepInputs WindowSimulator::Inputs(double time, bool with_directions) const {
  StepInputs inputs;
  std::vector<int> held;
  for (std::size_t h = 0; h < handles_.size(); ++h) {
    // A hair's breadth, so that rounding does not decide about the frame of the release itself.
    if (time > handles_[h].released_after + 1e-9) continue;
    inputs.handles.push_back({handles_[h].on_cloth, handles_[h].path.At(time)});
    held.push_back(static_cast<int>(h));
  }
  if (attracting_) attracting_->AddTargets(time, &inputs);
  if (with_directions) {
    bool any = false;
    for (const int h : held) any = any || !handles_[h].path.is_known();
    if (any) {
      inputs.directions.setZero(inputs.num_rows(), free_.size());
      for (std::size_t k = 0; k < held.size(); ++k) {
        inputs.directions.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
            free_.HandleDirections(handles_, held[k], time);
      }
      for (const int entry : held_) inputs.directions.col(entry).setZero();
    }
  }
  return inputs;
}

WindowSimulator::Outcome WindowSimulator::Run(const WindowStart& start,
                                              const Eigen::VectorXd& theta, int last_frame,
                                              bool derivatives, const Observer& observer,
                                              WindowStart* end) {
  report_ = {};
  if (!theta.allFinite()) return Outcome::kDiverged;
  simulation_.SetParameters(free_.Values(theta));
  simulation_.Reset();  // the same numbers whatever was simulated before
  free_.ApplyToHandles(theta, &handles_);
  State state = start.state;
  start.sensitivity.Move(theta - start.theta, &state);
  Sensitivity sensitivity;
  if (derivatives) {
    sensitivity = start.sensitivity;
    sensitivity.SetParameters(free_.ValueDirections(theta));
  }
  const Drive drive = [this](double time, bool with_directions) {
    return Inputs(time, with_directions);
  };
  Eigen::VectorXd key(1 + theta.size() + 2 * state.x.size());
  key << start.frame, theta, state.x, state.v;
  const bool is_known = derivatives && motion_.IsOf(key);
  if (!derivatives) motion_.Begin(key);
  std::size_t step = 0;
  observer(start.frame, state, derivatives ? &sensitivity : nullptr);
  for (int frame = start.frame + 1; frame <= last_frame; ++frame) {
    if (stop_ != nullptr && *stop_) return Outcome::kStopped;
    if (attracting_) attracting_->Approach(frame, state.x);
    for (int k = 0; k < scene_.steps_per_frame; ++k, ++step) {
      const StepReport report =
          simulation_.Advance(scene_.step, drive, &state, derivatives ? &sensitivity : nullptr,
                              is_known ? motion_.After(step) : nullptr);
      report_ += report;
      if (!derivatives) motion_.Add(report, state);
      if (report_.status != StepStatus::kConverged || !state.x.allFinite())
        return Outcome::kDiverged;
    }
    state.time = scene_.FrameTime(frame);
    if (!is_known) simulated_frames_ += 1.0;
    if (derivatives) differentiated_frames_ += sensitivity.ActiveShare();
    observer(frame, state, derivatives ? &sensitivity : nullptr);
  }
  if (end != nullptr) *end = {last_frame, std::move(state), std::move(sensitivity), theta};
  return Outcome::kComplete;
}

}  // namespace clothfit
