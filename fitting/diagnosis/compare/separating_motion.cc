// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/separating_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

// The recording's motion, otherwise.
struct OtherMotion {
  const char* name;
  double angle;  // rad, about the vertical through the middle of the cloth
  double speed;  // times as fast
};
constexpr std::array<OtherMotion, 6> kMotions = {
    {{"as it was recorded", 0.0, 1.0},
     {"turned by 90 degrees about the vertical", 0.5 * M_PI, 1.0},
     {"turned by 180 degrees about the vertical", M_PI, 1.0},
     {"twice as fast", 0.0, 2.0},
     {"half as fast", 0.0, 0.5},
     {"held still", 0.0, 0.0}}};

using Positions = std::vector<Eigen::VectorXd>;  // frame by frame, 3N, m

// As many frames as the recording has; none where the simulation fails.
Positions SimulateIn(const FittedScene& model, const OtherMotion& motion) {
  const Scene& scene = model.scene;
  const FreeParameters free(model.config, scene, MakeParameterTable());
  std::vector<SceneHandle> handles = scene.handles;
  free.ApplyToHandles(model.fit.theta, &handles);
  Eigen::VectorXd x, v;
  free.InitialState(model.fit.theta, &x, &v);
  Eigen::Map<Eigen::Matrix3Xd> points(x.data(), 3, x.size() / 3);
  Eigen::Map<Eigen::Matrix3Xd> velocities(v.data(), 3, v.size() / 3);
  const Eigen::Vector3d middle = points.rowwise().mean();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(motion.angle, scene.world.gravity.normalized()).toRotationMatrix();
  points = ((turn * (points.colwise() - middle)).colwise() + middle).eval();
  velocities = (motion.speed * turn * velocities).eval();

  Simulation simulation(scene.mesh, scene.world, scene.HandlePoints(), StepOptions(model.config));
  simulation.SetParameters(free.Values(model.fit.theta));
  State state = simulation.MakeState(x);
  state.v = v;
  const double end = scene.FrameTime(scene.recording.frame_count - 1);
  const Drive drive = [&](double time, bool) {
    const double then = std::min(end, motion.speed * time);
    StepInputs inputs;
    for (const SceneHandle& handle : handles) {
      if (then > handle.released_after + 1e-9) continue;
      inputs.handles.push_back({handle.on_cloth, turn * (handle.path.At(then) - middle) + middle});
    }
    return inputs;
  };
  Positions positions = {state.x};
  for (int frame = 1; frame < scene.recording.frame_count; ++frame) {
    for (int k = 0; k < scene.steps_per_frame; ++k) {
      if (simulation.Advance(scene.step, drive, &state).status != StepStatus::kConverged) return {};
    }
    positions.push_back(state.x);
  }
  return positions;
}

double RootMeanSquareDistance(const Positions& a, const Positions& b) {
  double sum = 0.0;
  Eigen::Index particles = 0;
  for (std::size_t frame = 0; frame < a.size(); ++frame) {
    sum += (a[frame] - b[frame]).squaredNorm();
    particles += a[frame].size() / 3;
  }
  return std::sqrt(sum / static_cast<double>(particles));
}

// Between the first and the nearest of the others; negative where one cannot be simulated.
double Apart(const std::vector<const FittedScene*>& models, const OtherMotion& motion) {
  const Positions first = SimulateIn(*models.front(), motion);
  if (first.empty()) return -1.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < models.size(); ++i) {
    const Positions other = SimulateIn(*models[i], motion);
    if (other.size() != first.size() || other.front().size() != first.front().size()) return -1.0;
    nearest = std::min(nearest, RootMeanSquareDistance(first, other));
  }
  return nearest;
}

}  // namespace

std::optional<SeparatingMotion> FindSeparatingMotion(
    const std::vector<const FittedScene*>& models) {
  if (models.size() < 2) return std::nullopt;
  SeparatingMotion best;
  best.apart_here = Apart(models, kMotions.front());
  if (best.apart_here < 0.0) return std::nullopt;
  best.apart = -1.0;
  const bool may_turn = models.front()->scene.world.obstacles.empty();
  for (std::size_t i = 1; i < kMotions.size(); ++i) {
    if (kMotions[i].angle != 0.0 && !may_turn) continue;
    const double apart = Apart(models, kMotions[i]);
    if (apart <= best.apart) continue;
    best.apart = apart;
    best.motion = kMotions[i].name;
  }
  if (best.apart < 0.0) return std::nullopt;
  return best;
}

std::string Describe(const SeparatingMotion& separating) {
  constexpr double kWorthIt = 1.5;
  const double here = 1000.0 * separating.apart_here, there = 1000.0 * separating.apart;
  if (there < kWorthIt * here) {
    return fmt::format(
        "None of the motions that were tried in simulation (turned, faster, slower, held still) "
        "would set them much further apart than the {:.2g} mm of this one.",
        here);
  }
  const auto mm = [](double value) { return fmt::format("{:.{}f}", value, value < 10.0 ? 1 : 0); };
  return fmt::format("The same motion {} would: they would be {} mm apart, here it is {}.",
                     separating.motion, mm(there), mm(here));
}

}  // namespace clothfit
