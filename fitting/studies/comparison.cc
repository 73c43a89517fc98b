// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/comparison.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/normal_numbers.h"
#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/surface_truth.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::optional<double> RmsFromTruth(const SurfaceTruth& truth, const SearchResult& found) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t frame = 0; frame < found.positions.size(); ++frame) {
    for (const double d : truth.PointDistances(static_cast<int>(frame), found.positions[frame])) {
      sum += d * d;
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(count));
}

const ComparedRun* FindRun(const Comparison* comparison, const std::string& contender, int start) {
  if (comparison == nullptr) return nullptr;
  for (const ComparedRun& run : comparison->runs) {
    if (run.contender == contender && run.start == start) return &run;
  }
  return nullptr;
}

ComparedRun RunOne(const Scene& scene, const FitConfig& config, const Contender& contender,
                   int start, const ComparisonOptions& options, double derivative_cost,
                   const std::optional<SurfaceTruth>& truth, const ComparisonCallbacks& callbacks) {
  FitConfig of_run = StartOf(config, options, start);
  of_run.optimiser = contender.optimiser;
  of_run.loops = contender.strategy;
  SearchOptions search;
  search.budget = options.budget;
  search.seed = options.seed + static_cast<unsigned>(start);
  search.num_threads = options.num_threads;
  search.derivative_cost = derivative_cost;
  search.stop = callbacks.stop;
  if (callbacks.progress) {
    search.progress = [&](const SearchPoint& point) {
      callbacks.progress(contender.name(), start, point);
    };
  }
  const SearchResult found = Search(scene, of_run, search);
  ComparedRun run;
  run.contender = contender.name();
  run.start = start;
  run.error = found.error;
  run.open_loop_error = found.open_loop_error;
  run.simulations = found.simulations;
  run.seconds = found.seconds;
  run.converged = found.converged;
  run.reason = found.reason;
  run.history = found.history;
  if (truth) run.truth_rms = RmsFromTruth(*truth, found);
  return run;
}

}  // namespace

Contender ParseContender(const std::string& place, const std::string& name) {
  const std::size_t slash = name.find('/');
  Contender contender;
  contender.optimiser = name.substr(0, slash);
  const std::vector<std::string>& names = OptimiserNames();
  if (std::find(names.begin(), names.end(), contender.optimiser) == names.end()) {
    throw InputError(place, "'" + contender.optimiser +
                                "': expected OPTIMISER or "
                                "OPTIMISER/STRATEGY with one of " +
                                JoinNames(names));
  }
  if (slash != std::string::npos) contender.strategy = ParseStrategy(place, name.substr(slash + 1));
  return contender;
}

std::optional<SearchPoint> ComparedRun::FirstBelow(double least) const {
  for (const SearchPoint& point : history) {
    if (point.error <= least) return point;
  }
  return std::nullopt;
}

FitConfig StartOf(const FitConfig& config, const ComparisonOptions& options, int start) {
  FitConfig moved = config;
  if (start == 0) return moved;
  NormalNumbers normal(options.seed, static_cast<std::uint64_t>(start));
  for (const NamedParameter& named : MakeParameterTable()) {
    ParameterSetting& setting = moved.parameters.at(named.name);
    if (!setting.free) continue;
    const double offset = options.spread * normal.Next();
    const double value = named.parameter.scale == Scale::kLog
                             ? setting.value * std::exp(offset)
                             : setting.value + setting.prior_sigma * offset;
    setting.value = std::clamp(value, setting.lower, setting.upper);
  }
  return moved;
}

Comparison Compare(const Scene& scene, const FitConfig& config, const ComparisonOptions& options,
                   const Comparison* done_before, const ComparisonCallbacks& callbacks) {
  const FreeParameters free(config, scene, MakeParameterTable());
  Comparison comparison;
  comparison.recording = scene.recording.name;
  comparison.frames = scene.last_fitted_frame + 1;
  comparison.particles = scene.mesh.num_particles();
  comparison.unknowns = free.size();
  comparison.fabric = static_cast<int>(free.Fabric().size());
  for (const Contender& contender : options.contenders)
    comparison.contenders.push_back(contender.name());
  // Counted, not measured, so that the same command comes to the same runs: derivatives go by
  // blocks of directions, and one of these takes about as long as a simulation.
  comparison.derivative_cost = 1.0 + std::ceil(static_cast<double>(free.size()) / kLanes);
  std::optional<SurfaceTruth> truth;
  if (HasTruthPoints(scene.recording.path)) truth.emplace(scene.recording.path, scene);
  for (int start = 0; start < options.num_starts; ++start) {
    for (const Contender& contender : options.contenders) {
      if (const ComparedRun* known = FindRun(done_before, contender.name(), start)) {
        comparison.runs.push_back(*known);
        continue;
      }
      ComparedRun run = RunOne(scene, config, contender, start, options, comparison.derivative_cost,
                               truth, callbacks);
      if (callbacks.stop != nullptr && *callbacks.stop) return comparison;
      comparison.runs.push_back(std::move(run));
      if (callbacks.done) callbacks.done(comparison);
    }
  }
  return comparison;
}

}  // namespace clothfit
