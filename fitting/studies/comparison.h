// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Optimisers and strategies side by side: the same recording, the same starts, one error that
// judges all.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fitting/fit/search.h"

namespace clothfit {

struct Contender {
  std::string optimiser;
  Strategy strategy = Strategy::kJoint;

  std::string name() const { return optimiser + "/" + ToString(strategy); }
};
// "pattern/two-loop"; without a strategy joint. Throws InputError, naming the place.
Contender ParseContender(const std::string& place, const std::string& name);

struct ComparisonOptions {
  std::vector<Contender> contenders;  // the last is the one that others are measured by
  int num_starts = 3;                 // the first is the config's
  double spread = 0.5;  // of the others, in logarithms or sigmas of the prior, normally distributed
  unsigned seed = 1;    // of the starts, and of optimisers that draw lots
  Budget budget;        // of each run; evaluations are simulations of the whole recording
  int num_threads = 1;  // of pattern search; the others have no use for more than one
};

// One contender from one start.
struct ComparedRun {
  std::string contender;
  int start = 0;
  double error = 0.0, open_loop_error = 0.0;  // see SearchResult
  std::optional<double> truth_rms;            // m, of the true points, where there are any
  double simulations = 0.0, seconds = 0.0;    // in all
  bool converged = false;
  std::string reason;
  std::vector<SearchPoint> history;

  // What had been spent when the error was this small for the first time.
  std::optional<SearchPoint> FirstBelow(double error) const;
};

struct Comparison {
  std::string recording;
  int frames = 0, particles = 0, unknowns = 0, fabric = 0;
  double derivative_cost = 0.0;  // a simulation with derivatives, in simulations without
  std::vector<std::string> contenders;
  std::vector<ComparedRun> runs;  // by start, then contender
};

// The config with its free parameters where start number `start` has them; they keep their priors.
FitConfig StartOf(const FitConfig& config, const ComparisonOptions& options, int start);

struct ComparisonCallbacks {
  std::function<void(const Comparison& so_far)> done;  // after each run
  std::function<void(const std::string& contender, int start, const SearchPoint&)> progress;
  const std::atomic<bool>* stop = nullptr;
};

// Runs what `done_before` does not hold already. A run that is stopped from outside is not part of
// the result. Truth is taken from the recording's truth/, where it has points.
Comparison Compare(const Scene& scene, const FitConfig& config, const ComparisonOptions& options,
                   const Comparison* done_before, const ComparisonCallbacks& callbacks);

// One contender over its starts, medians.
struct ContenderStanding {
  std::string name;
  int runs = 0, reached = 0;  // starts, and of those that came as low as the last contender
  double error = 0.0;
  // How many times less it had spent by then; above 1 is better. Only where reached.
  double simulations_lead = 0.0, seconds_lead = 0.0;
};
// Those that have ended a run, least error first.
std::vector<ContenderStanding> Standings(const Comparison& comparison);

// The table: medians and ranges over the starts, and how much sooner each contender had reached the
// final error of the last one.
std::string ComparisonAsMarkdown(const Comparison& comparison);
// One row a run; one row an improvement.
std::string ComparisonRunsAsCsv(const Comparison& comparison);
std::string ComparisonHistoryAsCsv(const Comparison& comparison);
// Error against simulations and against seconds.
std::string ComparisonAsSvg(const Comparison& comparison);

// comparison.json, from which an interrupted comparison goes on. Reading throws InputError.
void WriteComparison(const std::filesystem::path& file, const Comparison& comparison);
Comparison ReadComparison(const std::filesystem::path& file);

}  // namespace clothfit
