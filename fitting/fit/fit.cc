// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The fit as a whole: coarse, then fine.
#include "fitting/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "fitting/fit/fitter.h"

namespace clothfit {
namespace {

// The config of a fit with a coarser grid, where that is worth while: its iterations cost little,
// and stiffness and damping are the material's, not the mesh's.
std::optional<FitConfig> Coarser(const Scene& scene, const FitConfig& config) {
  const std::array<int, 2> grid = scene.mesh.grid;
  const int longer = std::max(grid[0], grid[1]), coarse = config.coarse_resolution;
  if (!scene.mesh.is_grid() || coarse < 2 || 3 * coarse > 2 * longer || !config.polish) {
    return std::nullopt;
  }
  constexpr int kIterationsToComeNear = 30;
  FitConfig coarser = config;
  coarser.max_iterations = std::min(config.max_iterations, kIterationsToComeNear);
  for (int k = 0; k < 2; ++k) {
    const double share = static_cast<double>(grid[k] - 1) / (longer - 1);
    coarser.resolution[k] = 1 + std::max(1, static_cast<int>(std::lround(share * (coarse - 1))));
  }
  return coarser;
}

constexpr double kShareOfCoarseFit = 0.3;  // of the time, a guess

FitCallbacks OfCoarseFit(const FitCallbacks& callbacks, const ClothMesh& mesh) {
  FitCallbacks own = callbacks;
  const std::string prefix = fmt::format("{} x {} particles, ", mesh.grid[0], mesh.grid[1]);
  if (callbacks.progress) {
    own.progress = [&callbacks, prefix](FitProgress progress) {
      progress.stage = prefix + progress.stage;
      progress.fraction *= kShareOfCoarseFit;
      callbacks.progress(progress);
    };
  }
  if (callbacks.checkpoint) {
    own.checkpoint = [&callbacks](FitCheckpoint checkpoint) {
      checkpoint.coarse = true;
      callbacks.checkpoint(checkpoint);
    };
  }
  if (callbacks.log) {
    own.log = [&callbacks, prefix](const std::string& line) { callbacks.log(prefix + line); };
  }
  return own;
}

FitCallbacks OfFineFit(const FitCallbacks& callbacks, const FitResult& coarse) {
  FitCallbacks own = callbacks;
  if (callbacks.progress) {
    own.progress = [&callbacks, &coarse](FitProgress progress) {
      progress.fraction = kShareOfCoarseFit + (1.0 - kShareOfCoarseFit) * progress.fraction;
      progress.simulated_frames += coarse.simulated_frames;
      progress.differentiated_frames += coarse.differentiated_frames;
      callbacks.progress(progress);
    };
  }
  return own;
}

}  // namespace

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

FitResult RunFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks,
                 const FitCheckpoint* resume) {
  const std::optional<FitConfig> coarser = Coarser(scene, config);
  if (!coarser || (resume != nullptr && !resume->coarse)) {
    return Fitter(scene, config, callbacks).Run(resume);
  }
  const Scene coarse_scene = MakeScene(scene.recording, *coarser, &scene);
  const FitCallbacks coarse_callbacks = OfCoarseFit(callbacks, coarse_scene.mesh);
  Fitter coarse_fitter(coarse_scene, *coarser, coarse_callbacks);
  coarse_fitter.OnlyComeNear();
  const FitResult coarse = coarse_fitter.Run(resume);
  const FitCallbacks fine_callbacks = OfFineFit(callbacks, coarse);
  Fitter fine(scene, config, fine_callbacks);
  fine.BeginNear();
  const FitCheckpoint reached = fine.AfterWindows(coarse.theta);
  FitResult result = fine.Run(&reached);
  result.iterations += coarse.iterations;
  result.simulations += coarse.simulations;
  result.simulated_frames += coarse.simulated_frames;
  result.differentiated_frames += coarse.differentiated_frames;
  result.seconds += coarse.seconds;
  return result;
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
