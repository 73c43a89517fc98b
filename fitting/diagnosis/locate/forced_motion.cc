// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/forced_motion.h"

#include "autodiff_sim/terms/residual_force.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {

ForcedMotion::ForcedMotion(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                           const ForceLayout& layout, const std::atomic<bool>* stop)
    : scene_(scene),
      free_(free),
      layout_(layout),
      stop_(stop),
      first_control_((free.size() + kLanes - 1) / kLanes * kLanes),
      simulation_(scene.mesh, scene.world, scene.HandlePoints(), StepOptions(config)),
      handles_(scene.handles) {
  share_ = RequireParameter(simulation_.model().parameters(), FullName<ResidualForce>());
  if (IsNudged(config)) attracting_.emplace(scene);
}

State ForcedMotion::FirstState(const Eigen::VectorXd& theta) const {
  Eigen::VectorXd x, v;
  free_.InitialState(theta, &x, &v);
  State state = simulation_.MakeState(x);
  state.v = v;
  return state;
}

Sensitivity ForcedMotion::FirstSensitivity(const State& state, const Eigen::VectorXd& theta) const {
  const Eigen::MatrixXd of_values = free_.ValueDirections(theta);
  Eigen::MatrixXd parameters = Eigen::MatrixXd::Zero(of_values.rows(), num_directions());
  parameters.leftCols(free_.size()) = of_values;
  Sensitivity sensitivity(state, parameters);
  Eigen::MatrixXd dx, dv;
  free_.InitialDirections(&dx, &dv);
  dx.conservativeResizeLike(Eigen::MatrixXd::Zero(dx.rows(), num_directions()));
  dv.conservativeResizeLike(Eigen::MatrixXd::Zero(dv.rows(), num_directions()));
  sensitivity.SetInitial(dx, dv);
  return sensitivity;
}

StepInputs ForcedMotion::Inputs(const Eigen::VectorXd& force, double time,
                                bool with_directions) const {
  StepInputs inputs;
  std::vector<int> held;
  for (std::size_t h = 0; h < handles_.size(); ++h) {
    if (time > handles_[h].released_after + 1e-9) continue;  // as WindowSimulator has it
    inputs.handles.push_back({handles_[h].on_cloth, handles_[h].path.At(time)});
    held.push_back(static_cast<int>(h));
  }
  if (attracting_) attracting_->AddTargets(time, &inputs);
  inputs.residual_force = layout_.At(force, time);
  if (!with_directions) return inputs;
  inputs.directions.setZero(inputs.num_rows(), num_directions());
  for (std::size_t k = 0; k < held.size(); ++k) {
    inputs.directions.block(3 * static_cast<Eigen::Index>(k), 0, 3, free_.size()) =
        free_.HandleDirections(handles_, held[k], time);
  }
  int knot = 0;
  double weight = 0.0;
  layout_.KnotBefore(time, &knot, &weight);
  for (int i = 0; i < layout_.per_knot(); ++i) {
    const Eigen::Index row = inputs.first_force_row() + i;
    const Eigen::Index column = first_control_ + layout_.Index(knot, 0, 0) + i;
    inputs.directions(row, column) = 1.0 - weight;
    inputs.directions(row, column + layout_.per_knot()) = weight;
  }
  return inputs;
}

bool ForcedMotion::Run(const Eigen::VectorXd& theta, const Eigen::VectorXd& force, int last_frame,
                       bool derivatives, const Observer& observer) {
  if (!theta.allFinite() || !force.allFinite()) return false;
  Eigen::VectorXd parameters = free_.Values(theta);
  parameters[share_] = 1.0;
  simulation_.SetParameters(parameters);
  simulation_.Reset();  // the same numbers whatever was simulated before
  free_.ApplyToHandles(theta, &handles_);
  State state = FirstState(theta);
  Sensitivity sensitivity;
  if (derivatives) sensitivity = FirstSensitivity(state, theta);
  Sensitivity* const carried = derivatives ? &sensitivity : nullptr;
  const Drive drive = [&](double time, bool with_directions) {
    return Inputs(force, time, with_directions);
  };
  observer(0, state, carried);
  for (int frame = 1; frame <= last_frame; ++frame) {
    if (stop_ != nullptr && *stop_) return false;
    for (int k = 0; k < scene_.steps_per_frame; ++k) {
      const StepReport report = simulation_.Advance(scene_.step, drive, &state, carried);
      if (report.status != StepStatus::kConverged || !state.x.allFinite()) return false;
    }
    state.time = scene_.FrameTime(frame);
    observer(frame, state, carried);
  }
  return true;
}

}  // namespace clothfit
