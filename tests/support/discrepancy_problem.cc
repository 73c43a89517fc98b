// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/discrepancy_problem.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/locate/forced_motion.h"
#include "fitting/diagnosis/model/switch_on.h"

namespace clothfit {
namespace {

constexpr double kSide = 0.4;          // m
constexpr double kMarkerSigma = 1e-3;  // m
constexpr double kTrackSigma = 0.5;    // px

// Nodes so dense that the planted rectangle has edges.
constexpr int kPlantedNodes = 17;

// The planted force by frames, over a grid of its own.
Eigen::VectorXd Planted(const PlantedForce& planted, const ForceLayout& layout) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(layout.size());
  for (int frame = planted.first_frame; frame <= planted.last_frame; ++frame) {
    for (int node = 0; node < layout.num_nodes(); ++node) {
      const Eigen::Vector2d uv = layout.NodePlace(node);
      constexpr double kEdge = 1e-9;  // m
      if ((uv - planted.low_uv).minCoeff() >= -kEdge && (planted.high_uv - uv).minCoeff() >= -kEdge)
        force[layout.Index(frame, node, 0)] = planted.along_normal;
    }
  }
  return force;
}

// Every particle's position by frame, with what the model lacks.
std::vector<Eigen::VectorXd> TrueMotion(const Scene& scene,
                                        const DiscrepancyProblemOptions& options,
                                        FitConfig config) {
  for (const auto& [name, value] : options.missing) config.parameters.at(name).value = value;
  const FreeParameters free(config, scene, MakeParameterTable());
  const double rate = scene.recording.frame_rate;
  const ForceLayout layout = MakeForceLayout(scene.mesh, {kPlantedNodes, kPlantedNodes}, rate,
                                             options.frames - 1, 1.0 / rate);
  ForcedMotion motion(scene, config, free, layout);
  std::vector<Eigen::VectorXd> x;
  const bool arrives =
      motion.Run(free.start(), Planted(options.planted, layout), options.frames - 1, false,
                 [&x](int, const State& state, const Sensitivity*) { x.push_back(state.x); });
  if (!arrives) throw std::runtime_error("the planted motion diverges");
  return x;
}

SyntheticOptions Scenery(const DiscrepancyProblemOptions& options) {
  SyntheticOptions synthetic;
  synthetic.parameters = {
      {"stretch.stiffness", 400.0}, {"stretch.damping", 0.4},     {"shear.stiffness", 8.0},
      {"shear.damping", 0.2},       {"bending.stiffness", 5e-5},  {"bending.damping", 5e-6},
      {"air_drag.normal", 0.3},     {"air_drag.saturation", 1.0}, {"air_drag.tangential", 0.05}};
  synthetic.size = {kSide, kSide};
  synthetic.resolution = {options.particles, options.particles};
  synthetic.frame_count = options.frames;
  synthetic.held_out_share = 0.0;
  synthetic.marker_sigma = kMarkerSigma;
  synthetic.track_sigma = kTrackSigma;
  synthetic.num_cameras = options.tracks_only ? 3 : 0;
  synthetic.seed = options.seed;
  return synthetic;
}

// Measures the markers and tracks of the scenery anew, on the true motion.
void Observe(const DiscrepancyProblemOptions& options, const Scene& scene,
             const std::vector<Eigen::VectorXd>& x, Recording* recording) {
  std::mt19937_64 random(options.seed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector2d> uv;
  for (const Marker& m : recording->markers) uv.push_back(m.uv);
  std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Marker& m = recording->markers[i];
    Eigen::Vector3d noise;
    for (double& value : noise.reverse()) value = normal(random);
    m.position = points[i].At(x[m.frame]) + kMarkerSigma * noise;
  }
  uv.clear();
  for (const Track& t : recording->tracks) uv.push_back(t.uv);
  points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Track& t = recording->tracks[i];
    Eigen::Vector2d noise;
    for (double& value : noise.reverse()) value = normal(random);
    const Eigen::Vector3d p = points[i].At(x[t.frame]);
    t.pixel = ProjectPoint<double>(recording->cameras[t.camera], p) + kTrackSigma * noise;
    if (t.camera == 1) t.pixel += options.shifted_camera;
  }
  if (options.tracks_only) recording->markers.clear();
}

}  // namespace

DiscrepancyProblem MakeDiscrepancyProblem(const DiscrepancyProblemOptions& options) {
  const SyntheticOptions synthetic = Scenery(options);
  Recording recording = MakeSyntheticRecording(synthetic).recording;
  DiscrepancyProblem problem;
  problem.config = DefaultConfig(recording);
  problem.config.loss = LossKind::kNone;
  problem.config.buckling = false;  // its equations are linear in what noise does
  for (auto& [name, setting] : problem.config.parameters) {
    setting.free = name == "bending.stiffness" || name == "air_drag.normal";
    const auto known = synthetic.parameters.find(name);
    if (known != synthetic.parameters.end()) setting.value = setting.prior = known->second;
  }
  const Scene scene = MakeScene(recording, problem.config);
  problem.true_x = TrueMotion(scene, options, problem.config);
  Observe(options, scene, problem.true_x, &recording);
  problem.scene = MakeScene(recording, problem.config);
  constexpr double kShare = 0.03;  // as strong as the last of a guided fit
  if (options.held) {
    problem.config = *NudgedConfig(problem.config, problem.scene, kShare, kScoringDamping);
    problem.scene = MakeScene(recording, problem.config);  // with the tracks' rays
  }
  problem.free =
      std::make_unique<FreeParameters>(problem.config, problem.scene, MakeParameterTable());
  problem.theta = problem.free->start();
  return problem;
}

Eigen::MatrixXd NoiseNulls(const DiscrepancyProblem& problem, int count, std::uint64_t seed) {
  const ObservationResiduals observations(problem.scene, problem.config);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd nulls(observations.Count(0, problem.scene.last_fitted_frame), count);
  for (Eigen::Index i = 0; i < nulls.size(); ++i) nulls.data()[i] = normal(random);
  return nulls;
}

double IntersectionOverUnion(const Eigen::Vector2d& low1, const Eigen::Vector2d& high1,
                             const Eigen::Vector2d& low2, const Eigen::Vector2d& high2) {
  const Eigen::Vector2d shared = (high1.cwiseMin(high2) - low1.cwiseMax(low2)).cwiseMax(0.0);
  return shared.prod() / ((high1 - low1).prod() + (high2 - low2).prod() - shared.prod());
}

}  // namespace clothfit
