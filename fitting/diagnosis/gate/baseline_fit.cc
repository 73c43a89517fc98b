// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/gate/baseline_fit.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

// The recording's mesh, made coarser where it is finer than a diagnosis may use.
std::array<int, 2> WorkingResolution(const Recording& recording, const FitConfig& config,
                                     int finest_side) {
  std::array<int, 2> grid = config.resolution;
  if (grid[0] == 0) grid = {recording.cloth.resolution.x(), recording.cloth.resolution.y()};
  if (LongerSide(grid) <= finest_side) return config.resolution;
  return GridWithSide(grid, finest_side);
}

}  // namespace

FittedScene FitBaseline(const Recording& recording, const FitConfig& baseline,
                        const DiagnosisOptions& options) {
  FitConfig config = baseline;
  // Nobody lays out a cloth exactly.
  config.initial_order = std::max(config.initial_order, 1);
  config.resolution =
      WorkingResolution(recording, config, std::min(options.finest_side, kCoarseSide));
  Scene scene = MakeScene(recording, config);
  FitConfig quick = config;
  quick.function_tolerance = std::max(config.function_tolerance, kEnoughForDiagnosis);
  // Outlines are not led to their motion by windows, and all that follows goes on from here.
  const int most = HasPoints(scene) ? kBaselineIterations : 4 * kBaselineIterations;
  quick.max_iterations = std::min(config.max_iterations, most);
  FitCallbacks callbacks;
  callbacks.log = options.log;
  callbacks.progress = [&options](const FitProgress& p) {
    if (options.progress) options.progress("baseline: " + p.stage, 0.2 * p.fraction);
  };
  const FitResult fit = FitRunner(options).Run(scene, quick, nullptr, callbacks);
  FittedScene fitted = MakeFittedScene(std::move(scene), config, fit);
  if (fitted.fit.status == FitStatus::kFailed)
    throw std::runtime_error("the baseline's fit failed: the simulation diverges");
  return fitted;
}

}  // namespace clothfit
