// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/force.h"

#include <cmath>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

TrueForceMeter::TrueForceMeter(const Trial& trial)
    : frame_rate_(trial.recording.frame_rate), frame_count_(trial.recording.frame_count) {
  for (const PlantedEffect& effect : trial.effects) {
    for (const Parameter& parameter : TermOf(effect.term).parameters) {
      if (SwitchesOff(parameter)) switches_.push_back(effect.term + "." + parameter.name);
    }
  }
}

std::function<void(const Simulation&, const State&, const State&)> TrueForceMeter::Observer() {
  return [this](const Simulation& simulation, const State& before, const State& after) {
    Add(simulation, before, after);
  };
}

void TrueForceMeter::Add(const Simulation& simulation, const State& before, const State& after) {
  const ClothModel& model = simulation.model();
  const double step = after.time - before.time;
  const Eigen::VectorXd acceleration = (after.v - before.v) / step;
  const Eigen::VectorXd force =
      ForceOfParameters(model,
                        {after.time, step, after.x, after.v, acceleration, before.x,
                         simulation.parameters(), before.memory},
                        switches_);
  if (!meter_) meter_.emplace(model.topology().areas, frame_count_);
  const long frame = std::lround(std::ceil(after.time * frame_rate_ - 1e-6));
  meter_->Add(static_cast<int>(frame), force, after.x, after.v, step);
}

ActingForce TrueForceMeter::Result(const ClothMesh& mesh) const {
  return meter_ ? meter_->Result(mesh) : ActingForce();
}

}  // namespace clothfit
