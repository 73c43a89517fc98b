// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/classify/acting_force.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "autodiff_sim/mesh/cloth_box.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

// What each particle has is spread evenly over its part of one side of the cloth (m), what each
// frame has over the time since the one before (frames).
struct Spread {
  double low, high;
  double amount;
};

struct Stretch {
  double low, high;
};

// Where this share of all amounts lies below.
double Quantile(const std::vector<Spread>& spreads, double share) {
  double low = HUGE_VAL, high = -HUGE_VAL, all = 0.0;
  for (const Spread& s : spreads) {
    low = std::min(low, s.low);
    high = std::max(high, s.high);
    all += s.amount;
  }
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    double below = 0.0;
    for (const Spread& s : spreads)
      below += s.amount * std::clamp((middle - s.low) / (s.high - s.low), 0.0, 1.0);
    (below < share * all ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What holds all but this share at either end, longer by as much as of what is even.
Stretch Middle(const std::vector<Spread>& spreads, double outside) {
  const double low = Quantile(spreads, outside), high = Quantile(spreads, 1.0 - outside);
  const double more = 0.5 * (high - low) * (1.0 / (1.0 - 2.0 * outside) - 1.0);
  return {low - more, high + more};
}

}  // namespace

ForceMeter::ForceMeter(std::vector<double> areas, int frame_count)
    : areas_(std::move(areas)),
      of_frames_(static_cast<std::size_t>(frame_count), 0.0),
      of_particles_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(areas_.size()))) {}

void ForceMeter::Add(int frame, const Eigen::VectorXd& force, const Eigen::VectorXd& x,
                     const Eigen::VectorXd& v, double step) {
  const Eigen::Index n = of_particles_.size();
  const Eigen::Vector3d middle =
      Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, n).rowwise().mean();
  Eigen::Vector3d net = Eigen::Vector3d::Zero(), moment = net;
  double parts = 0.0, part_moments = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d f = force.segment<3>(3 * i);
    const Eigen::Vector3d arm = x.segment<3>(3 * i) - middle;
    const double area = areas_[static_cast<std::size_t>(i)];
    of_particles_[i] += f.squaredNorm() / (area * area);
    net += f;
    moment += arm.cross(f);
    parts += f.norm();
    part_moments += arm.norm() * f.norm();
  }
  const auto last = static_cast<int>(of_frames_.size()) - 1;
  of_frames_[static_cast<std::size_t>(std::clamp(frame, 0, last))] += force.squaredNorm();
  net_ += net;
  parts_ += parts;
  net2_ += net.squaredNorm();
  moment2_ += moment.squaredNorm();
  parts2_ += parts * parts;
  part_moments2_ += part_moments * part_moments;
  const double work = force.dot(v) * step;
  (work > 0.0 ? work_in_ : work_out_) += std::abs(work);
  ++num_steps_;
}

ActingForce ForceMeter::Result(const ClothMesh& mesh) const {
  ActingForce result;
  result.work_in = work_in_;
  result.work_out = work_out_;
  const double most = num_steps_ > 0 ? of_particles_.maxCoeff() : 0.0;
  if (!(most > 0.0)) return result;
  result.acts = true;
  result.peak = std::sqrt(most / num_steps_);
  result.mean_direction = net_ / parts_;
  result.net_force_share = std::sqrt(net2_ / parts2_);
  result.net_moment_share = std::sqrt(moment2_ / std::max(1e-300, part_moments2_));
  FindRegion(mesh, &result);
  FindFrames(&result);
  return result;
}

// The strongest places alone would do for no region: the force per area is largest at single
// particles of the edge, which stand for little of it.
void ForceMeter::FindRegion(const ClothMesh& mesh, ActingForce* result) const {
  constexpr double kOutside = 0.1;  // of the force, on either side
  const auto [low, high] = BoxOf(mesh);
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<Spread> spreads;
    for (int i = 0; i < mesh.num_particles(); ++i) {
      const double area = areas_[static_cast<std::size_t>(i)];
      const double side =
          mesh.is_grid() ? (high[axis] - low[axis]) / (mesh.grid[axis] - 1) : std::sqrt(area);
      const double at = mesh.uv[i][axis];
      spreads.push_back({std::max(low[axis], at - 0.5 * side),
                         std::min(high[axis], at + 0.5 * side),
                         area * std::sqrt(of_particles_[i])});
    }
    const Stretch middle = Middle(spreads, kOutside);
    result->low_uv[axis] = std::max(low[axis], middle.low);
    result->high_uv[axis] = std::min(high[axis], middle.high);
  }
}

// A jerk of the first frame may be larger than a tenth of all that follows, too.
void ForceMeter::FindFrames(ActingForce* result) const {
  constexpr double kOutside = 0.01;
  constexpr double kRounding = 1e-6;  // frames
  const int last = static_cast<int>(of_frames_.size()) - 1;
  if (last < 1) return;
  std::vector<Spread> spreads;  // frame 0 has no step of its own
  for (int frame = 1; frame <= last; ++frame) {
    const double squares = of_frames_[static_cast<std::size_t>(frame)];
    spreads.push_back({frame - 1.0, frame * 1.0, std::sqrt(squares)});
  }
  const Stretch middle = Middle(spreads, kOutside);
  const int first = 1 + static_cast<int>(std::floor(middle.low + kRounding));
  result->first_frame = first <= 1 ? 0 : first;
  result->last_frame = std::clamp(static_cast<int>(std::ceil(middle.high - kRounding)), 1, last);
}

Eigen::VectorXd ForceOfParameters(const ClothModel& model, const ForcePoint& at,
                                  const std::vector<std::string>& names) {
  Eigen::VectorXd off = at.parameters;
  for (const std::string& name : names) {
    const int index = RequireParameter(model.parameters(), name);
    off[index] = model.parameters()[index].parameter.off;
  }
  Eigen::VectorXd with, without, memory = at.memory;
  model.Forces(at, &with, &memory);
  memory = at.memory;
  model.Forces({at.time, at.step, at.x, at.v, at.a, at.start, off, at.memory}, &without, &memory);
  return with - without;
}

std::vector<std::string> SwitchesOf(const std::vector<std::string>& effects) {
  std::vector<std::string> names;
  for (const NamedParameter& named : MakeParameterTable()) {
    const bool is_asked = std::any_of(
        effects.begin(), effects.end(),
        [&](const std::string& effect) { return effect == named.term || effect == named.name; });
    if (is_asked && SwitchesOff(named.parameter)) names.push_back(named.name);
  }
  return names;
}

std::optional<ActingForce> MeasureActingForce(const FittedScene& fitted,
                                              const std::vector<std::string>& effects) {
  const Scene& scene = fitted.scene;
  const FreeParameters free(fitted.values, scene, MakeParameterTable());
  WindowSimulator simulator(scene, fitted.values, free, false, nullptr);
  const std::vector<std::string> names = SwitchesOf(effects);
  const ClothModel& model = simulator.simulation().model();
  ForceMeter meter(model.topology().areas, scene.last_fitted_frame + 1);
  const Eigen::VectorXd theta = ThetaOfPass(free, fitted.unknown);
  const Eigen::VectorXd parameters = free.Values(theta);
  const double frame_time = 1.0 / scene.recording.frame_rate;
  Eigen::VectorXd v_before;
  const auto outcome = simulator.Run(
      simulator.FirstStart(theta), theta, scene.last_fitted_frame, false,
      [&](int frame, const State& state, const Sensitivity*) {
        if (v_before.size() > 0) {
          // The memory is that after the step: what a term remembers is held for an instant.
          const Eigen::VectorXd acceleration = (state.v - v_before) / frame_time;
          const Eigen::VectorXd start = state.x - scene.step * state.v;
          const ForcePoint at{state.time,   scene.step, state.x,    state.v,
                              acceleration, start,      parameters, state.memory};
          meter.Add(frame, ForceOfParameters(model, at, names), state.x, state.v, frame_time);
        }
        v_before = state.v;
      });
  if (outcome != WindowSimulator::Outcome::kComplete) return {};
  return meter.Result(scene.mesh);
}

}  // namespace clothfit
