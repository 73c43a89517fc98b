// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/gate/baseline_fit.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/fit/other_starts.h"

namespace clothfit {
namespace {

constexpr double kNearly = 1.5;  // times the cost before: worth going on from

// The recording's mesh, made coarser where it is finer than a diagnosis may use.
std::array<int, 2> WorkingResolution(const Recording& recording, const FitConfig& config,
                                     int finest_side) {
  std::array<int, 2> grid = config.resolution;
  if (grid[0] == 0) grid = {recording.cloth.resolution.x(), recording.cloth.resolution.y()};
  if (std::max(grid[0], grid[1]) <= finest_side) return config.resolution;
  return GridWithSide(grid, finest_side);
}

double CostOf(const FitResult& fit) {
  const bool is_usable = fit.status != FitStatus::kFailed;
  return is_usable ? fit.cost_after : std::numeric_limits<double>::infinity();
}

// A few iterations from other material parameters each, and all of them from the best.
FittedScene FitFromOthers(FittedScene best, const DiagnosisOptions& options) {
  const auto log = [&](const std::string& line) {
    if (options.log) options.log(line);
  };
  const FitRunner runner(options);
  std::vector<std::pair<FitConfig, Start>> starts;
  const std::vector<FitConfig> others = OtherStarts(best.config);
  for (const FitConfig& other : others) starts.push_back({other, Start::kPlain});
  starts.push_back({best.config, Start::kNudged});
  if (options.progress) options.progress("baseline: other starts", 0.2);
  const int count = static_cast<int>(starts.size());
  std::vector<std::optional<FittedScene>> fits(starts.size());
  ParallelFor(count, NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    if (runner.IsStopped()) return;
    const auto& [config, how] = starts[k];
    fits[k] = FitAfresh({best.scene.recording, config}, how, kFirstIterations, runner);
  });
  std::optional<FittedScene> from;
  double least = kNearly * CostOf(best.fit);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (!fits[k]) continue;
    const double cost = CostOf(fits[k]->fit);
    const bool is_nudged = starts[k].second == Start::kNudged;
    log(fmt::format("{}: cost {:.6g}",
                    is_nudged ? "nudged to what was observed" : "from other material parameters",
                    cost));
    if (!(cost < least)) continue;
    least = cost;
    from = std::move(fits[k]);
  }
  if (!from || runner.IsStopped()) return best;
  std::optional<FittedScene> fitted =
      FitModel(*from, GoOn(*from), best.config.max_iterations, runner);
  if (!fitted) fitted = std::move(from);
  log(fmt::format("to the end from there: cost {:.6g}", CostOf(fitted->fit)));
  if (!(CostOf(fitted->fit) < CostOf(best.fit))) return best;
  fitted->config = best.config;  // it begins where it is told to, not where this one did
  return std::move(*fitted);
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
  FitCallbacks callbacks;
  callbacks.log = options.log;
  callbacks.progress = [&options](const FitProgress& p) {
    if (options.progress) options.progress("baseline: " + p.stage, 0.2 * p.fraction);
  };
  FitResult fit = FitRunner(options).Run(scene, quick, nullptr, callbacks);
  const bool is_off = MayBeLocalMinimum(scene, quick, fit);
  FittedScene fitted = MakeFittedScene(std::move(scene), config, fit);
  if (is_off) fitted = FitFromOthers(std::move(fitted), options);
  if (fitted.fit.status == FitStatus::kFailed)
    throw std::runtime_error("the baseline's fit failed: the simulation diverges");
  return fitted;
}

}  // namespace clothfit
