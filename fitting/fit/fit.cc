// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/fit.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "fitting/fit/fitter.h"
#include "fitting/fit/forecast_fit.h"
#include "fitting/fit/joint_fit.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {

std::string ToString(FitStatus status) {
  switch (status) {
    case FitStatus::kConverged:
      return "converged";
    case FitStatus::kNotConverged:
      return "not converged";
    case FitStatus::kInterrupted:
      return "interrupted";
    case FitStatus::kFailed:
      return "failed";
  }
  return "unknown";
}

namespace {

// The config of a fit with a coarser grid, where that is worth while: its iterations cost little,
// and stiffness and damping are the material's, not the mesh's.
std::optional<FitConfig> Coarser(const Scene& scene, const FitConfig& config) {
  const std::array<int, 2> grid = scene.mesh.grid;
  const int longer = LongerSide(grid);
  const int coarse =
      FitsWindows(scene, config) ? config.window_resolution : config.coarse_resolution;
  const bool is_of_use = scene.mesh.is_grid() && coarse >= 2 && 3 * coarse <= 2 * longer;
  if (!is_of_use || !config.polish) return std::nullopt;
  constexpr int kIterationsToComeNear = 30;
  FitConfig coarser = config;
  coarser.max_iterations = std::min(config.max_iterations, kIterationsToComeNear);
  coarser.resolution = GridWithSide(grid, coarse);
  return coarser;
}

// All recordings with coarser grids, where that is worth while of any.
class CoarserScenes {
 public:
  explicit CoarserScenes(const std::vector<NamedScene>& scenes) {
    configs_.reserve(scenes.size());
    scenes_.reserve(scenes.size());
    for (const auto& [name, scene, config] : scenes) {
      const std::optional<FitConfig> coarser = Coarser(*scene, *config);
      are_of_use_ = are_of_use_ || coarser;
      configs_.push_back(coarser.value_or(*config));
      scenes_.push_back(coarser ? MakeScene(scene->recording, *coarser, scene) : *scene);
      named_.push_back({name, &scenes_.back(), &configs_.back()});
    }
  }
  CoarserScenes(const CoarserScenes&) = delete;
  CoarserScenes& operator=(const CoarserScenes&) = delete;

  bool are_of_use() const { return are_of_use_; }
  const std::vector<NamedScene>& named() const { return named_; }

 private:
  bool are_of_use_ = false;
  std::vector<FitConfig> configs_;
  std::vector<Scene> scenes_;
  std::vector<NamedScene> named_;
};

// Its share of the whole fit's progress is a guess.
FitCallbacks OfCoarseFit(const FitCallbacks& callbacks, const Scene& scene, double share) {
  FitCallbacks of_coarse = OfPart(callbacks, GridAsText(scene) + " particles, ", 0.0, share);
  if (callbacks.checkpoint) {
    of_coarse.checkpoint = [&callbacks](FitCheckpoint checkpoint) {
      checkpoint.coarse = true;
      callbacks.checkpoint(checkpoint);
    };
  }
  return of_coarse;
}

}  // namespace

void AddWork(const FitResult& other, FitResult* result) {
  result->iterations += other.iterations;
  result->simulated_frames += other.simulated_frames;
  result->differentiated_frames += other.differentiated_frames;
  result->simulations += other.simulations;
  result->seconds += other.seconds;
}

FitCallbacks OfPart(const FitCallbacks& callbacks, const std::string& name, double from,
                    double share) {
  FitCallbacks part;
  part.stop = callbacks.stop;
  part.journal = callbacks.journal;
  part.checkpoint = callbacks.checkpoint;
  part.stands = callbacks.stands;
  if (callbacks.log)
    part.log = [&callbacks, name](const std::string& line) { callbacks.log(name + line); };
  if (callbacks.progress) {
    part.progress = [&callbacks, name, from, share](FitProgress progress) {
      progress.stage = name + progress.stage;
      progress.fraction = from + share * progress.fraction;
      callbacks.progress(progress);
    };
  }
  return part;
}

FitResult RunFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks,
                 const FitCheckpoint* resume, bool tells_misfit) {
  return RunJointFit({{"", &scene, &config}}, callbacks, resume, tells_misfit);
}

FitResult RunJointFit(const std::vector<NamedScene>& scenes, const FitCallbacks& callbacks,
                      const FitCheckpoint* resume, bool tells_misfit) {
  const auto begin = std::chrono::steady_clock::now();
  FitResult before;  // with the work of the coarse fit
  Fitter fitter(scenes, callbacks);
  fitter.MeasureStart(&before);
  const bool begins_coarse = resume == nullptr || resume->coarse;
  const CoarserScenes coarser(begins_coarse ? scenes : std::vector<NamedScene>());
  if (coarser.are_of_use()) {
    // Windows come near enough; without them, so does a fit of all frames.
    const bool any_windows = std::any_of(scenes.begin(), scenes.end(), [](const NamedScene& one) {
      return FitsWindows(*one.scene, *one.config);
    });
    const double share = any_windows ? 0.7 : 0.3;  // windows have their own share of it already
    const FitCallbacks of_coarse = OfCoarseFit(callbacks, *coarser.named()[0].scene, share);
    Fitter first(coarser.named(), of_coarse);
    first.OnlyComeNear();
    first.Begin(resume);
    if (!any_windows) first.Advance(coarser.named()[0].config->max_iterations);
    first.AddWorkTo(&before);
    const FitCheckpoint reached = fitter.AfterWindows(first.theta());
    fitter.BeginNear();
    fitter.Begin(&reached);
  } else {
    fitter.Begin(resume);
  }
  fitter.Advance(scenes[0].config->max_iterations);
  if (tells_misfit) fitter.TellMisfit();
  FitResult result = fitter.End();
  result.before = before.before;
  result.cost_before = before.cost_before;
  result.iterations += before.iterations;
  result.simulated_frames += before.simulated_frames;
  result.differentiated_frames += before.differentiated_frames;
  int frames = 0;
  for (const NamedScene& one : scenes) frames += one.scene->last_fitted_frame;
  result.simulations = static_cast<int>(std::ceil(result.simulated_frames / std::max(1, frames)));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

int NumForecastLengths(const Scene& scene, const FitConfig& config) {
  const std::vector<int> lengths = WindowLengths(scene, config);
  const double most = kLeadTime * scene.recording.frame_rate;
  const auto longer =
      std::find_if(lengths.begin(), lengths.end(), [&](int length) { return length > most; });
  const auto count = static_cast<int>(longer - lengths.begin());
  return lengths.empty() ? 0 : std::max(1, count);
}

FitResult FitForecasts(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks,
                       const FitCheckpoint* from, int most_lengths) {
  return Fitter(scene, config, callbacks)
      .Forecast(NumForecastLengths(scene, config), most_lengths, from);
}

FitResult GoOnFitting(const Scene& scene, const FitConfig& config, const Eigen::VectorXd& theta,
                      const FitCallbacks& callbacks) {
  const auto begin = std::chrono::steady_clock::now();
  Fitter fitter(scene, config, callbacks);
  const FitCheckpoint reached = fitter.AfterWindows(theta);
  fitter.BeginNear();
  fitter.Begin(&reached);
  fitter.Advance(config.max_iterations);
  fitter.TellMisfit();
  FitResult result = fitter.End();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

FitResult AppraiseFit(const Scene& scene, const FitConfig& config, const Eigen::VectorXd& theta) {
  const FitCallbacks none;  // outlives the fitter, which refers to it
  Fitter fitter(scene, config, none);
  fitter.TellMisfit();
  return fitter.At(theta);
}

int SimulateFrames(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                   const Eigen::VectorXd& theta, int last_frame,
                   const std::function<void(int frame, const State& state)>& observer,
                   StepReport* steps) {
  WindowSimulator simulator(scene, config, free, false, nullptr);
  int frames = 0;
  simulator.Run(simulator.FirstStart(theta), theta, last_frame, false,
                [&](int frame, const State& state, const Sensitivity*) {
                  observer(frame, state);
                  ++frames;
                });
  if (steps != nullptr) *steps = simulator.last_report();
  return frames;
}

}  // namespace clothfit
