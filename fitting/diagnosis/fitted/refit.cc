// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/refit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/fit/forecast_fit.h"
#include "fitting/rollout/shooting_windows.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

// Weaker and weaker: what pulls also hides a part of what is wrong.
constexpr double kNudgingShares[] = {1.0, 0.2, 0.03};
constexpr int kNudgedIterations = 3;  // of each
// Particles a side: where something pulls, the motion is as good on a coarse mesh.
constexpr int kNudgedSide = 13;

// Where a fit begins that nothing is handed on to.
FitCheckpoint Beginning(const FreeParameters& free) {
  FitCheckpoint from;
  from.theta = free.start();
  return from;
}

// Where a fit of the same unknowns goes on that is to begin with no offsets of the start.
FitCheckpoint FromPathsOf(const FitResult& before, const FreeParameters& free) {
  FitCheckpoint from = Beginning(free);
  for (int i = 0; i < free.size(); ++i) {
    if (free.entries()[i].kind == FreeEntry::Kind::kHandle) from.theta[i] = before.theta[i];
  }
  return from;
}

// Begins where what was fitted before has its handles' paths, where there was such a fit.
FitResult RunAfter(const std::optional<FitResult>& before, const Scene& scene,
                   const FitConfig& config, const FitRunner& runner) {
  if (!before) return runner.Run(scene, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  const FitCheckpoint from = FromPathsOf(*before, free);
  return runner.Run(scene, config, &from);
}

// Begins from what was fitted.
void BeginFrom(const FitResult& fit, FitConfig* config) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    ParameterSetting& setting = config->parameters.at(table[i].name);
    if (setting.free) setting.value = Inside(fit.parameters[static_cast<Eigen::Index>(i)], setting);
  }
}

FitConfig OnNudgedMesh(FitConfig config, const ClothMesh& mesh) {
  if (mesh.is_grid() && LongerSide(mesh.grid) > kNudgedSide)
    config.resolution = GridWithSide(mesh.grid, kNudgedSide);
  return config;
}

// What was fitted quickly, to be gone on with as the config `own` says.
std::optional<FittedScene> MakeModel(Scene scene, const FitConfig& own, FitConfig quick,
                                     const FitResult& result) {
  if (result.status == FitStatus::kFailed || !std::isfinite(result.cost_after)) return std::nullopt;
  quick.window = own.window;
  quick.coarse_resolution = own.coarse_resolution;
  quick.max_iterations = own.max_iterations;
  quick.function_tolerance = own.function_tolerance;
  return MakeFittedScene(std::move(scene), quick, result);
}

}  // namespace

double EnoughToDecide(const Scene& scene) {
  return (HasPoints(scene) ? 0.1 : 1.0) * kEnoughForDiagnosis;
}

double Inside(double value, const ParameterSetting& setting) {
  return std::clamp(value, setting.lower, setting.upper);
}

FitConfig QuickConfig(FitConfig config, int most_iterations, double tolerance) {
  config.coarse_resolution = 0;
  config.window = 0.0;
  config.max_iterations = std::min(config.max_iterations, most_iterations);
  config.function_tolerance = std::max(config.function_tolerance, tolerance);
  return config;
}

ModelStart GoOn(const FittedScene& model) {
  ModelStart start{model.scene.recording, model.config};
  for (auto& [name, setting] : start.config.parameters)
    setting.value = model.values.parameters.at(name).value;
  return start;
}

ModelStart GoOnWithout(const FittedScene& model, const std::vector<std::string>& names) {
  ModelStart start = GoOn(model);
  for (const std::string& name : names) {
    ParameterSetting& setting = start.config.parameters.at(name);
    setting.value = ParameterNamed(name).off;
    setting.free = false;
  }
  return start;
}

ModelStart WithoutEffect(const FittedScene& before, const FittedScene& model) {
  ModelStart start = GoOn(before);
  for (auto& [name, setting] : start.config.parameters) {
    if (setting.free) setting.value = Inside(model.values.parameters.at(name).value, setting);
  }
  return start;
}

ModelStart WithMaterialOf(const FitConfig& given, ModelStart start) {
  for (auto& [name, setting] : start.config.parameters) {
    const ParameterSetting& own = given.parameters.at(name);
    if (own.free) setting.value = own.value;
  }
  return start;
}

std::optional<FittedScene> FitNudged(const ModelStart& start, double damping,
                                     const FitRunner& runner) {
  FitConfig next = QuickConfig(start.config, kNudgedIterations, kEnoughForDiagnosis);
  next.attract = true;
  next = OnNudgedMesh(next, MakeScene(start.recording, next).mesh);
  const Scene scene = MakeScene(start.recording, next);
  std::optional<FitResult> before;
  for (const double share : kNudgingShares) {
    const std::optional<FitConfig> pulled = NudgedConfig(next, scene, share, damping);
    if (!pulled) return {};
    before = RunAfter(before, scene, *pulled, runner);
    if (before->status == FitStatus::kFailed) return {};
    next = *pulled;
    BeginFrom(*before, &next);
  }
  return MakeFittedScene(scene, next, *before);
}

std::optional<FittedScene> FitAfresh(const ModelStart& start, Start how, int most_iterations,
                                     const FitRunner& runner, double tolerance) {
  FitConfig quick = QuickConfig(start.config, most_iterations, tolerance);
  if (how == Start::kWindows) quick.window = start.config.window;
  Scene scene = MakeScene(start.recording, quick);
  if (how == Start::kWindows && !FitsWindows(scene, quick)) return {};
  const FitResult result = runner.Run(scene, quick);
  return MakeModel(std::move(scene), start.config, quick, result);
}

std::optional<FittedScene> FitModel(const FittedScene& fitted, const ModelStart& start,
                                    int most_iterations, const FitRunner& runner,
                                    double tolerance) {
  const FitConfig config = QuickConfig(start.config, most_iterations, tolerance);
  Scene scene = MakeScene(start.recording, config, &fitted.scene);
  // Handles and initial state go on from where they were; they follow the parameters.
  const FreeParameters free(config, scene, MakeParameterTable());
  FitCheckpoint from = Beginning(free);
  from.next_window = 1;
  from.theta.tail(fitted.unknown.size()) = fitted.unknown;
  const FitResult result = runner.Run(scene, config, &from);
  return MakeModel(std::move(scene), start.config, config, result);
}

std::optional<FittedScene> FitOnGrid(const std::array<int, 2>& grid, const FittedScene& fitted,
                                     int most_iterations, const FitRunner& runner) {
  ModelStart start = GoOn(fitted);
  start.config.resolution = grid;
  return FitModel(fitted, start, most_iterations, runner, EnoughToDecide(fitted.scene));
}

std::optional<FittedScene> FitToForecasts(const ModelStart& start, const std::array<int, 2>& grid,
                                          const ForecastLengths& lengths, const FitRunner& runner,
                                          const FittedScene* after) {
  FitConfig config = start.config;
  config.resolution = grid;
  FitConfig quick = config;
  quick.max_iterations = std::min(config.max_iterations, lengths.most_iterations);
  quick.function_tolerance = std::max(config.function_tolerance, kEnoughForDiagnosis);
  Scene scene = MakeScene(start.recording, config, after != nullptr ? &after->scene : nullptr);
  if (!FitsWindows(scene, config)) return {};
  const FreeParameters free(config, scene, MakeParameterTable());
  FitCheckpoint from = Beginning(free);
  from.next_window = lengths.first;
  if (after != nullptr) from.theta.tail(after->unknown.size()) = after->unknown;
  const FitResult result = runner.RunForecasts(scene, quick, &from, lengths.last);
  // One that was interrupted may have come to no misfit, by which it could be judged.
  if (!result.misfit || !std::isfinite(result.cost_after)) return {};
  FittedScene fitted = MakeFittedScene(std::move(scene), config, result);
  fitted.of_forecasts = true;
  return fitted;
}

std::optional<FittedScene> FitBeyondForecasts(const FittedScene& forecasts, int most_iterations,
                                              const FitRunner& runner) {
  FitConfig config =
      QuickConfig(forecasts.config, most_iterations, EnoughToDecide(forecasts.scene));
  config.window = forecasts.config.window;
  FitCheckpoint from;
  from.theta = forecasts.fit.theta;
  from.next_window = NumForecastLengths(forecasts.scene, config);
  const FitResult result = runner.Run(forecasts.scene, config, &from);
  return MakeModel(forecasts.scene, forecasts.config, config, result);
}

std::optional<FittedScene> FitToAllFrames(const FitConfig& given, const FittedScene& before,
                                          const FittedScene& forecasts,
                                          const std::array<int, 2>& coarse, int most_iterations,
                                          const FitRunner& runner) {
  constexpr int kAfresh = 4;  // times as many iterations as from where forecasts have ended
  std::optional<FittedScene> best = FitBeyondForecasts(forecasts, most_iterations, runner);
  const bool follows = best && !HasLargeResidual(best->scene, best->config, best->fit);
  if (!follows && !runner.IsStopped()) {
    ModelStart start = WithMaterialOf(given, GoOn(forecasts));
    start.config.resolution = coarse;
    std::optional<FittedScene> afresh =
        FitAfresh(start, Start::kWindows, kAfresh * most_iterations, runner);
    const std::array<int, 2>& grid = forecasts.scene.mesh.grid;
    if (afresh && grid != coarse) afresh = FitOnGrid(grid, *afresh, most_iterations, runner);
    best = Cheaper(std::move(best), std::move(afresh));
  }
  const bool is_lowest = best && best->fit.cost_after <= before.fit.cost_after;
  if (is_lowest || before.of_forecasts || runner.IsStopped()) return best;
  const ModelStart from_before = WithMaterialOf(GoOn(before).config, GoOn(forecasts));
  return Cheaper(std::move(best), FitModel(before, from_before, most_iterations, runner,
                                           EnoughToDecide(before.scene)));
}

std::optional<FittedScene> Cheaper(std::optional<FittedScene> a, std::optional<FittedScene> b) {
  const bool is_second = b && (!a || b->fit.cost_after < a->fit.cost_after);
  return is_second ? std::move(b) : std::move(a);
}

}  // namespace clothfit
