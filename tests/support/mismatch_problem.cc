// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/mismatch_problem.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "autodiff_sim/force_batch_impl.h"
#include "autodiff_sim/terms.h"
#include "fitting/recovery_study.h"
#include "fitting/window_simulator.h"
#include "tracking/silhouette_raster.h"

namespace clothfit {
namespace {

constexpr double kSide = 0.4;         // m
constexpr double kMarkerSigma = 1e-3;  // m
constexpr double kTrackSigma = 0.5;    // px

// The planted force, as a term of this problem's own: it shares no code with what is to find it.
struct Planted {
  static constexpr int kFirst = 0, kLast = 1, kForce = 2;
  static PlantedForce force;  // of the recording that is being made
};
PlantedForce Planted::force;

struct PlantedTerm : TermDefaults {
  static constexpr const char* kName = "planted";
  static constexpr const char* kDoc = "a push along the normal on a rectangle for a time";
  static constexpr const char* kReference = "";
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 1> kParameters = {{
      {"push", "N/m^2", "", 0.0, 0.0, -100.0, 100.0, Scale::kLinear, 1.0},
  }};
  struct Element {
    std::array<int, 3> nodes;
    double share;  // of the triangle that lies in the rectangle: by points within it
  };
  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    const PlantedForce& f = Planted::force;
    for (const std::array<int, 3>& t : context.mesh.triangles) {
      constexpr int kAlong = 12;
      int inside = 0, all = 0;
      for (int i = 0; i < kAlong; ++i) {
        for (int j = 0; i + j < kAlong; ++j, ++all) {
          const double a = (i + 1.0 / 3.0) / kAlong, b = (j + 1.0 / 3.0) / kAlong;
          const Eigen::Vector2d uv = (1.0 - a - b) * context.mesh.uv[t[0]] +
                                     a * context.mesh.uv[t[1]] + b * context.mesh.uv[t[2]];
          inside += (uv - f.low_uv).minCoeff() >= 0.0 && (f.high_uv - uv).minCoeff() >= 0.0;
        }
      }
      if (inside > 0) elements.push_back({t, static_cast<double>(inside) / all});
    }
    return elements;
  }
  template <class T>
  static void AddForce(const Element& e, const ElementInput<PlantedTerm, T>& in,
                       ElementOutput<PlantedTerm, T>* out) {
    const double frame = 60.0 * in.time;
    if (frame <= Planted::force.first_frame - 0.5 || frame > Planted::force.last_frame + 0.5)
      return;
    const Vector3<T> side1 = in.x[1] - in.x[0], side2 = in.x[2] - in.x[0];
    const Vector3<T> force = side1.cross(side2) * (in.parameter[0] * (e.share / 6.0));
    for (Vector3<T>& corner : out->force) corner += force;
  }
};

template <class... Terms>
auto WithPlanted(TypeList<Terms...>) {
  return TypeList<Terms..., PlantedTerm>{};
}

// Every particle's position by frame, with what the model lacks.
std::vector<Eigen::VectorXd> TrueMotion(const Scene& scene, const MismatchProblemOptions& options,
                                        const FitConfig& config) {
  Planted::force = options.planted;
  SimulationOptions steps = StepOptions(config);
  Simulation simulation = Simulation::WithTerms(WithPlanted(Terms{}), scene.mesh, scene.world,
                                                scene.HandlePoints(), steps);
  const std::vector<NamedParameter>& table = simulation.model().parameters();
  Eigen::VectorXd values = simulation.parameters();
  for (const auto& [name, setting] : config.parameters)
    values[FindParameter(table, name)] = setting.value;
  for (const auto& [name, value] : options.missing) values[FindParameter(table, name)] = value;
  values[FindParameter(table, "planted.push")] = options.planted.along_normal;
  simulation.SetParameters(values);
  const Drive drive = [&](double time, bool) {
    StepInputs inputs;
    for (const SceneHandle& handle : scene.handles)
      inputs.handles.push_back({handle.on_cloth, handle.path.At(time)});
    return inputs;
  };
  State state = simulation.MakeState(scene.initial);
  std::vector<Eigen::VectorXd> x = {state.x};
  for (int frame = 1; frame < options.frames; ++frame) {
    for (int k = 0; k < scene.steps_per_frame; ++k) {
      if (simulation.Advance(scene.step, drive, &state).status != StepStatus::kConverged)
        throw std::runtime_error("the planted motion diverges");
    }
    state.time = scene.FrameTime(frame);
    x.push_back(state.x);
  }
  return x;
}

SyntheticOptions Scenery(const MismatchProblemOptions& options) {
  SyntheticOptions synthetic = DemoRecording();
  synthetic.size = {kSide, kSide};
  synthetic.resolution = {options.particles, options.particles};
  synthetic.frame_count = options.frames;
  synthetic.held_out_share = 0.0;
  synthetic.marker_sigma = kMarkerSigma;
  synthetic.track_sigma = kTrackSigma;
  synthetic.num_cameras = options.tracks_only || options.silhouettes_only ? 3 : 0;
  synthetic.seed = options.seed;
  return synthetic;
}

// Measures the markers and tracks of the scenery anew, on the true motion.
void Observe(const MismatchProblemOptions& options, const Scene& scene,
             const std::vector<Eigen::VectorXd>& x, Recording* recording) {
  std::mt19937_64 random(options.seed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector2d> uv;
  for (const Marker& m : recording->markers) uv.push_back(m.uv);
  std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Marker& m = recording->markers[i];
    const Eigen::Vector3d noise(normal(random), normal(random), normal(random));
    m.position = points[i].At(x[m.frame]) + kMarkerSigma * noise;
  }
  uv.clear();
  for (const Track& t : recording->tracks) uv.push_back(t.uv);
  points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Track& t = recording->tracks[i];
    const Eigen::Vector2d noise(normal(random), normal(random));
    const Eigen::Vector3d p = points[i].At(x[t.frame]);
    t.pixel = ProjectPoint<double>(recording->cameras[t.camera], p) + kTrackSigma * noise;
    if (t.camera == 1) t.pixel += options.shifted_camera;
  }
  if (options.tracks_only) recording->markers.clear();
}

}  // namespace

MismatchProblem MakeMismatchProblem(const MismatchProblemOptions& options) {
  const SyntheticOptions synthetic = Scenery(options);
  Recording recording = MakeSyntheticRecording(synthetic).recording;
  MismatchProblem problem;
  problem.config = DefaultConfig(recording);
  problem.config.loss = LossKind::kNone;
  problem.config.use_silhouettes = options.silhouettes_only;
  for (auto& [name, setting] : problem.config.parameters) {
    setting.free = name == "bending.stiffness" || name == "air_drag.normal";
    const auto known = synthetic.parameters.find(name);
    if (known != synthetic.parameters.end()) setting.value = setting.prior = known->second;
  }
  Scene scene = MakeScene(recording, problem.config);
  problem.true_x = TrueMotion(scene, options, problem.config);
  Observe(options, scene, problem.true_x, &recording);
  if (options.silhouettes_only) {
    recording.markers.clear();
    recording.tracks.clear();
    auto silhouettes = std::make_shared<Silhouettes>();
    for (int frame = 0; frame < options.frames; ++frame) {
      for (int c = 0; c < static_cast<int>(recording.cameras.size()); ++c) {
        BitMask mask;
        SilhouetteRaster(recording.cameras[c], scene.mesh.triangles)
            .Draw(problem.true_x[frame], &mask);
        silhouettes->observations.push_back(MakeSilhouette(frame, c, mask.ToMat()));
      }
    }
    scene.silhouettes = silhouettes;
  }
  problem.scene = MakeScene(recording, problem.config, &scene);
  problem.free =
      std::make_unique<FreeParameters>(problem.config, problem.scene, MakeParameterTable());
  problem.theta = problem.free->start();
  return problem;
}

Eigen::MatrixXd NoiseNulls(const MismatchProblem& problem, int count, std::uint64_t seed) {
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
