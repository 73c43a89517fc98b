// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole fits by any strategy, and what follows where Levenberg-Marquardt stalls.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fitter.h"
#include "fitting/fit/rugged_cost.h"
#include "fitting/fit/search.h"
#include "fitting/fit/two_starts.h"
#include "fitting/scene/grid_side.h"

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
  AddWork(before, result);
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

bool MayBeRefined(const Scene& scene, const FitConfig& config) {
  const bool is_given = !config.refined && config.resolution != std::array<int, 2>{0, 0};
  return !is_given && scene.mesh.is_grid() && LongerSide(scene.mesh.grid) < config.finest &&
         config.loops == Strategy::kJoint && config.optimiser == "lm";
}

// Of the discretisation error, in sigmas: what of it is in the residuals. More than all of it is
// something else.
double MeshInResiduals(const Misfit& misfit) {
  return misfit.discretisation.value_or(0.0) * std::clamp(misfit.amplitude.value_or(0.0), 0.0, 1.0);
}

constexpr double kNegligibleMesh = 0.5;  // sigmas of mesh and step, which make 1.12 of one of noise

// A fit that has used up its iterations does not: it is not known what it would leave.
bool AsksForFinerMesh(const FitResult& fit) {
  const bool is_at_rest =
      fit.status == FitStatus::kConverged ||
      (fit.status == FitStatus::kNotConverged && !RuggedCostAmong(fit.statements).empty());
  return is_at_rest && fit.misfit && !fit.misfit->IsNoise() &&
         MeshInResiduals(*fit.misfit) > kNegligibleMesh;
}

// On which mesh, by an error of second order, no more than that should be left.
int NextSide(const Scene& scene, const FitOnMesh& fit) {
  const int side = LongerSide(scene.mesh.grid);
  const double ratio = std::sqrt(MeshInResiduals(*fit.result.misfit) / kNegligibleMesh);
  const int enough = 1 + static_cast<int>(std::ceil(ratio * (side - 1)));
  return std::min(fit.config.finest, std::max(FinerSide(side), enough));
}

// Why the mesh is as fine as it is.
std::string SayMesh(const Scene& first, const Scene& chosen, const FitOnMesh& fit) {
  const std::string refined = fmt::format("the mesh was refined from {} to {} particles",
                                          GridAsText(first), GridAsText(chosen));
  const bool is_finest = LongerSide(chosen.mesh.grid) >= fit.config.finest;
  if (!is_finest || !AsksForFinerMesh(fit.result)) return refined;
  return fmt::format("{}, the finest that may be chosen (--finest)", refined);
}

std::string SayNoFinerMesh(const Scene& finer) {
  return fmt::format("a mesh of {} particles explains no more", GridAsText(finer));
}

// A finer mesh, from where the fit has ended. False where it explains no more.
bool Refine(const Scene& scene, int side, const FitCallbacks& callbacks, FitOnMesh* fit) {
  FitOnMesh finer = *fit;
  finer.config.resolution = GridWithSide(scene.mesh.grid, side);
  finer.config.refined = true;
  finer.scene = std::make_shared<const Scene>(MakeScene(scene.recording, finer.config, &scene));
  Log(callbacks, fmt::format("mesh and step leave {:.2g} times the noise in the residuals: on with "
                             "{} particles",
                             MeshInResiduals(*fit->result.misfit), GridAsText(*finer.scene)));
  finer.result =
      GoOnFitting(*finer.scene, finer.config, fit->result.theta,
                  OfPart(callbacks, GridAsText(*finer.scene) + " particles, ", 0.0, 1.0));
  const bool is_better =
      finer.result.misfit && finer.result.misfit->chi_square < fit->result.misfit->chi_square;
  if (is_better) {
    Add(fit->result, &finer.result);
    *fit = std::move(finer);
    return true;
  }
  AddWork(finer.result, &fit->result);
  if (finer.result.status == FitStatus::kInterrupted)
    fit->result.status = FitStatus::kInterrupted;
  else
    fit->result.statements.push_back(SayNoFinerMesh(*finer.scene));
  return false;
}

}  // namespace

FitOnMesh FitOnChosenMesh(const Scene& scene, const FitConfig& config,
                          const FitCallbacks& callbacks) {
  FitOnMesh fit;
  fit.config = config;
  double left = 1.0;  // of the progress; half of it where another fit may follow
  const auto part = [&](bool is_last) {
    const double share = is_last ? left : 0.5 * left;
    left -= share;
    return OfPart(callbacks, "", 1.0 - left - share, share);
  };
  const auto now = [&]() -> const Scene& { return fit.scene ? *fit.scene : scene; };
  fit.result = FitByStrategy(scene, config, part(!MayBeRefined(scene, config)));
  bool is_finer = true;
  while (is_finer && MayBeRefined(now(), fit.config) && AsksForFinerMesh(fit.result)) {
    if (callbacks.stands) callbacks.stands(now(), fit.config, fit.result);
    const int side = NextSide(now(), fit);
    is_finer = Refine(now(), side, part(side >= fit.config.finest), &fit);
  }
  if (fit.scene) fit.result.statements.push_back(SayMesh(scene, *fit.scene, fit));
  return fit;
}

FitResult FitByStrategy(const Scene& scene, const FitConfig& config,
                        const FitCallbacks& callbacks) {
  if (config.loops != Strategy::kJoint || config.optimiser != "lm")
    return FitBySearch(scene, config, callbacks);
  FitResult result = FitFromTwoStarts({{"", &scene, &config}}, callbacks);
  const bool stalls = result.status == FitStatus::kNotConverged && config.polish_hard &&
                      config.FitsSilhouettes() && scene.silhouettes && NumFabric(scene, config) > 0;
  return stalls ? PolishOnHardError(scene, config, callbacks, std::move(result)) : result;
}

}  // namespace clothfit
