// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Simulates a scenario and observes it.
#include "tracking/synthetic/recording.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/scenes/cloth_scene.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "tracking/files/output_folder.h"
#include "tracking/recording/clouds/file.h"
#include "tracking/synthetic/keys.h"
#include "tracking/synthetic/observations.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool IsHidden(const SyntheticOptions& options, const std::string& handle) {
  return std::find(options.hidden_handles.begin(), options.hidden_handles.end(), handle) !=
         options.hidden_handles.end();
}

// Every particle's position (3N, m) in every frame.
class Generator {
 public:
  Generator(const SyntheticOptions& options, const SyntheticMotion& motion,
            const SyntheticGenerator& generator)
      : options_(options),
        motion_(motion),
        generator_(generator),
        mesh_(MakeGrid(options.size, {options.refinement * (options.resolution.x() - 1) + 1,
                                      options.refinement * (options.resolution.y() - 1) + 1})) {
    mesh_.buckles = options.buckling;
    std::vector<Vector2d> uv;
    for (const SyntheticHandle& handle : motion.handles) uv.push_back(handle.uv);
    handles_ = LocateOnCloth(mesh_, uv);
  }

  const std::map<std::string, double>& parameters() const { return parameters_; }

  // The positions after every step where they are needed, else in every frame.
  SyntheticSurface Run(const SyntheticProgress& progress) {
    World world;
    world.ground_height = motion_.ground_height;
    SimulationOptions simulation_options;
    simulation_options.integrator = options_.integrator;
    Simulation simulation = generator_.make
                                ? generator_.make(mesh_, world, handles_, simulation_options)
                                : Simulation(mesh_, world, handles_, simulation_options);
    SetParameters(&simulation);
    const FlatPlacement& flat = motion_.initial;
    State state = simulation.MakeState(LayFlat(mesh_, flat.origin, flat.u_axis, flat.v_axis));
    const Drive drive = [this](double time, bool) {
      StepInputs inputs;
      for (std::size_t h = 0; h < handles_.size(); ++h)
        inputs.handles.push_back({handles_[h], motion_.handles[h].path(time)});
      return inputs;
    };
    const bool keeps_steps = options_.images && options_.pictures.exposure > 0.0;
    const double step = 1.0 / (options_.frame_rate * options_.steps_per_frame);
    SyntheticSurface surface{mesh_, keeps_steps ? step : 1.0 / options_.frame_rate, {state.x}};
    for (int frame = 1; frame < options_.frame_count; ++frame) {
      for (int k = 0; k < options_.steps_per_frame; ++k) {
        const State before = generator_.observe ? state : State();
        if (simulation.Advance(step, drive, &state).status != StepStatus::kConverged) {
          throw std::runtime_error(fmt::format("the simulation diverges in frame {}", frame));
        }
        if (generator_.observe) generator_.observe(simulation, before, state);
        if (keeps_steps) surface.positions.push_back(state.x);
      }
      state.time = static_cast<double>(frame) / options_.frame_rate;
      if (!keeps_steps) surface.positions.push_back(state.x);
      if (progress) progress(static_cast<double>(frame) / (options_.frame_count - 1), "simulation");
    }
    return surface;
  }

 private:
  void SetParameters(Simulation* simulation) {
    const std::vector<NamedParameter>& table = simulation->model().parameters();
    Eigen::VectorXd values = InitialValues(table);
    for (const auto& given : {options_.parameters, generator_.parameters}) {
      for (const auto& [name, value] : given) {
        values[RequireParameter(table, name, "generator")] = value;
      }
    }
    simulation->SetParameters(values);
    for (std::size_t i = 0; i < table.size(); ++i)
      parameters_[table[i].name] = values[static_cast<Eigen::Index>(i)];
  }

  const SyntheticOptions& options_;
  const SyntheticMotion& motion_;
  const SyntheticGenerator& generator_;
  ClothMesh mesh_;
  std::vector<SurfacePoint> handles_;
  std::map<std::string, double> parameters_;  // every one, by its full name
};

// Every parameter's value for a generator that is not clothfit's own.
std::map<std::string, double> ParametersOf(const SyntheticOptions& options,
                                           const SyntheticGenerator& generator) {
  std::map<std::string, double> values;
  for (const NamedParameter& named : MakeParameterTable())
    values[named.name] = named.parameter.initial;
  for (const auto& [name, value] : options.parameters) values[name] = value;
  for (const auto& [name, value] : generator.parameters) values[name] = value;
  return values;
}

// What the recording says of its scene, without observations.
Recording DescribeScene(const SyntheticOptions& options, const SyntheticMotion& motion,
                        double areal_density) {
  Recording recording;
  recording.name = options.name;
  recording.frame_rate = options.frame_rate;
  recording.frame_count = options.frame_count;
  recording.ground_height = motion.ground_height;
  recording.cloth.size = options.size;
  recording.cloth.resolution = options.resolution;
  if (options.tell_density) recording.cloth.areal_density = areal_density;
  recording.cloth.initial = motion.initial;
  for (const SyntheticHandle& handle : motion.handles) {
    HandleDescription description;
    description.name = handle.name;
    description.uv = handle.uv;
    if (!IsHidden(options, handle.name)) {
      HandleDescription::Path path;
      for (int f = 0; f < options.frame_count; ++f)
        path.push_back(RoundedPosition(handle.path(f / options.frame_rate)));
      description.path = path;
      description.path_sigma = 1e-6;  // m, the rounding
    }
    recording.handles.push_back(description);
  }
  const int held_out = static_cast<int>(std::floor(options.held_out_share * options.frame_count));
  if (held_out > 0) {
    recording.splits.held_out_frames = {options.frame_count - held_out, options.frame_count - 1};
  }
  return recording;
}

std::vector<Eigen::VectorXd> Frames(const SyntheticSurface& surface,
                                    const SyntheticOptions& options) {
  std::vector<Eigen::VectorXd> frames;
  for (int f = 0; f < options.frame_count; ++f)
    frames.push_back(surface.At(f / options.frame_rate));
  return frames;
}

}  // namespace

SyntheticRecording MakeSyntheticRecording(const SyntheticOptions& options,
                                          const SyntheticProgress& progress,
                                          const SyntheticGenerator& generator) {
  options.Check("synthetic recording");
  const SyntheticMotion motion =
      MakeSyntheticMotion(options.scenario, options.size, options.Duration());
  SyntheticRecording result;
  if (generator.simulate) {
    result.truth_parameters = ParametersOf(options, generator);
    result.surface = generator.simulate(options, motion, result.truth_parameters, progress);
  } else {
    Generator run(options, motion, generator);
    result.surface = run.Run(progress);
    result.truth_parameters = run.parameters();
  }
  const ClothMesh& mesh = result.surface.mesh;
  const std::vector<Eigen::VectorXd> frames = Frames(result.surface, options);
  result.recording =
      DescribeScene(options, motion, result.truth_parameters.at("cloth.areal_density"));
  AddCameras(options, frames, &result.recording);
  AddMarkers(options, mesh, frames, &result.recording);
  AddTracks(options, mesh, frames, &result.recording);
  result.clouds = MakeClouds(options, mesh, frames, &result.recording);
  result.truth_points = TruthPoints(options, mesh, frames);
  return result;
}

std::map<std::string, std::string> FilesOf(const SyntheticRecording& synthetic) {
  std::map<std::string, std::string> files = FilesOf(synthetic.recording);
  for (std::size_t f = 0; f < synthetic.clouds.size(); ++f)
    files[fmt::format("clouds/{:06d}.ply", f)] = CloudAsPly(synthetic.clouds[f]);
  files[kTruthPointsFile] = TruthPointsAsCsv(synthetic.truth_points);
  files[kTruthParametersFile] = TruthParametersAsYaml(synthetic.truth_parameters);
  return files;
}

SyntheticRecording Synthesize(const SyntheticOptions& options, const std::filesystem::path& folder,
                              Overwrite overwrite, const SyntheticProgress& progress) {
  options.Check("synthetic recording");
  // What cannot be written is told before the simulation, which takes a while.
  OutputFolder output(folder, FolderKind::kRecording, "synthesize", ExistingIf(overwrite));
  SyntheticRecording synthetic = MakeSyntheticRecording(options, progress);
  std::map<std::string, std::string> files = FilesOf(synthetic);
  files["truth/synthesize.yaml"] = SyntheticConfigAsYaml(options);
  std::vector<std::string> names = NamesOf(files);
  if (options.images) {
    const std::vector<std::string> pictures =
        SyntheticPictureFiles(options.pictures, synthetic.recording);
    names.insert(names.end(), pictures.begin(), pictures.end());
  }
  output.Begin(names);
  output.WriteAll(files);
  if (options.images) {
    WriteSyntheticPictures(options.pictures, options.seed, synthetic.recording, synthetic.surface,
                           folder, progress);
  }
  return synthetic;
}

}  // namespace clothfit
