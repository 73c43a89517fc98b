// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole fits by any strategy, and what follows where Levenberg-Marquardt stalls.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fitter.h"
#include "fitting/fit/search.h"

namespace clothfit {
namespace {

void Log(const FitCallbacks& callbacks, const std::string& line) {
  if (callbacks.log) callbacks.log(line);
}

std::size_t NumFabric(const Scene& scene, const FitConfig& config) {
  return FreeParameters(config, scene, MakeParameterTable()).Fabric().size();
}

void Show(const FitCallbacks& callbacks, const std::string& stage, const SearchPoint& point,
          double most_simulations) {
  if (!callbacks.progress || !std::isfinite(point.error)) return;
  FitProgress progress;
  progress.stage = stage;
  progress.iteration = static_cast<int>(point.simulations);
  progress.cost = point.error;
  progress.detail = fmt::format("{:.0f} simulations, error {:.6g}", point.simulations, point.error);
  progress.fraction = std::isfinite(most_simulations) && most_simulations < 1e200
                          ? std::min(1.0, point.simulations / most_simulations)
                          : 0.0;
  callbacks.progress(progress);
}

void Add(const SearchResult& search, const Scene& scene, FitResult* result) {
  result->simulated_frames += search.simulations * std::max(1, scene.last_fitted_frame);
  result->simulations += static_cast<int>(std::ceil(search.simulations));
  result->seconds += search.seconds;
}

void Add(const FitResult& before, FitResult* result) {
  result->before = before.before;
  result->cost_before = before.cost_before;
  result->iterations += before.iterations;
  result->simulated_frames += before.simulated_frames;
  result->differentiated_frames += before.differentiated_frames;
  result->simulations += before.simulations;
  result->seconds += before.seconds;
}

// The hard error where Levenberg-Marquardt's soft one gets no further. May cost as many simulations
// as the fit before it did.
FitResult PolishOnHardError(const Scene& scene, const FitConfig& config,
                            const FitCallbacks& callbacks, FitResult fit) {
  FitConfig polish = config;
  polish.optimiser = NumFabric(scene, config) > 1 ? "bobyqa" : "sbplx";
  SearchOptions options;
  options.start = fit.theta;
  options.fabric_only = true;
  options.step_scale = 0.1;  // the fit is near
  options.budget.evaluations = fit.simulations;
  options.stop = callbacks.stop;
  options.journal = callbacks.journal;
  options.progress = [&](const SearchPoint& point) {
    Show(callbacks, "polish on the hard error", point, options.budget.evaluations);
  };
  const SearchResult found = Search(scene, polish, options);
  const double before = found.history.empty() ? found.error : found.history.front().error;
  Log(callbacks, fmt::format("stalled on the soft silhouette error; {} on the hard error of the "
                             "fabric alone: {:.6g} -> {:.6g} in {:.0f} simulations, {}",
                             polish.optimiser, before, found.error, found.simulations,
                             found.error < before ? "kept" : "nothing gained"));
  if (!(found.error < before)) {
    Add(found, scene, &fit);
    return fit;
  }
  FitResult polished = Fitter(scene, config, callbacks).At(found.theta);
  Add(fit, &polished);
  Add(found, scene, &polished);
  return polished;
}

FitResult FitBySearch(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks) {
  const std::string name = config.optimiser + "/" + ToString(config.loops);
  Fitter fitter(scene, config, callbacks);
  SearchOptions options;
  if (config.max_simulations > 0.0) options.budget.evaluations = config.max_simulations;
  options.journal = callbacks.journal;
  options.derivative_cost = 1.0;  // simulations are counted, not weighed
  options.stop = callbacks.stop;
  options.progress = [&](const SearchPoint& point) {
    Show(callbacks, name, point, options.budget.evaluations);
  };
  options.improved = [&](const Eigen::VectorXd& theta) {
    if (callbacks.checkpoint) callbacks.checkpoint(fitter.AfterWindows(theta));
  };
  const SearchResult found = Search(scene, config, options);
  Log(callbacks, fmt::format("{}: hard error {:.6g} after {:.0f} simulations, {}", name,
                             found.error, found.simulations, found.reason));
  FitResult result = fitter.At(found.theta);
  Add(found, scene, &result);
  if (found.converged && result.status == FitStatus::kNotConverged)
    result.status = FitStatus::kConverged;
  if (config.loops != Strategy::kJoint) {
    result.statements.push_back(fmt::format(
        "frame by frame the error was {:.6g}; one simulation from the start, as this run has it, "
        "comes to {:.6g}",
        found.error, found.open_loop_error));
  }
  return result;
}

}  // namespace

FitResult FitByStrategy(const Scene& scene, const FitConfig& config,
                        const FitCallbacks& callbacks) {
  if (config.loops != Strategy::kJoint || config.optimiser != "lm")
    return FitBySearch(scene, config, callbacks);
  FitResult result = RunFit(scene, config, callbacks, nullptr, true);
  const bool stalls = result.status == FitStatus::kNotConverged && config.polish_hard &&
                      config.FitsSilhouettes() && scene.silhouettes && NumFabric(scene, config) > 0;
  return stalls ? PolishOnHardError(scene, config, callbacks, std::move(result)) : result;
}

}  // namespace clothfit
