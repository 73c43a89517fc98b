// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/trial_force.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/parameter_table.h"

namespace clothfit {

TrueForceMeter::TrueForceMeter(const Trial& trial)
    : frame_rate_(trial.recording.frame_rate),
      of_frames_(static_cast<std::size_t>(trial.recording.frame_count), 0.0) {
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
  Eigen::VectorXd off = simulation.parameters();
  for (const std::string& name : switches_) {
    const int index = FindParameter(model.parameters(), name);
    off[index] = model.parameters()[index].parameter.off;
  }
  const auto force_with = [&](const Eigen::VectorXd& parameters) {
    Eigen::VectorXd force, memory = before.memory;
    model.Forces(
        {after.time, step, after.x, after.v, acceleration, before.x, parameters, before.memory},
        &force, &memory);
    return force;
  };
  const Eigen::VectorXd force = force_with(simulation.parameters()) - force_with(off);
  const std::vector<double>& areas = model.topology().areas;
  if (of_particles_.size() == 0) {
    of_particles_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(areas.size()));
  }
  for (Eigen::Index i = 0; i < of_particles_.size(); ++i)
    of_particles_[i] += force.segment<3>(3 * i).squaredNorm() / (areas[i] * areas[i]);
  const long frame = std::lround(std::ceil(after.time * frame_rate_ - 1e-6));
  of_frames_[std::clamp<std::size_t>(frame, 0, of_frames_.size() - 1)] += force.squaredNorm();
  const double work = force.dot(after.v) * step;
  (work > 0.0 ? work_in_ : work_out_) += std::abs(work);
  ++num_steps_;
}

TrueForce TrueForceMeter::Result(const ClothMesh& mesh) const {
  TrueForce result;
  result.work_in = work_in_;
  result.work_out = work_out_;
  const double most = num_steps_ > 0 ? of_particles_.maxCoeff() : 0.0;
  if (!(most > 0.0)) return result;
  result.acts = true;
  result.peak = std::sqrt(most / num_steps_);
  result.low_uv = Eigen::Vector2d::Constant(HUGE_VAL);
  result.high_uv = -result.low_uv;
  for (int i = 0; i < mesh.num_particles(); ++i) {
    if (of_particles_[i] < 0.25 * most) continue;  // squares: half of the largest
    result.low_uv = result.low_uv.cwiseMin(mesh.uv[i]);
    result.high_uv = result.high_uv.cwiseMax(mesh.uv[i]);
  }
  // Frame 0 has no step of its own.
  const double largest = *std::max_element(of_frames_.begin(), of_frames_.end());
  const int count = static_cast<int>(of_frames_.size());
  const auto is_on = [&](int frame) { return of_frames_[frame] >= 0.01 * largest; };
  int first = 1, last = count - 1;
  while (first < count && !is_on(first)) ++first;
  while (last > first && !is_on(last)) --last;
  result.first_frame = first == 1 ? 0 : first;
  result.last_frame = last;
  return result;
}

}  // namespace clothfit
