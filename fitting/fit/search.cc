// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/search.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/files/evaluation_journal.h"
#include "fitting/fit/frame_by_frame.h"
#include "fitting/fit/recalled_evaluation.h"
#include "fitting/fit/search_ledger.h"
#include "fitting/residuals/synthesis_error.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPathSigma = 0.001;  // m, of splines through the paths of a pass frame by frame

// Large enough to change the silhouettes by many pixels, small enough to stay where the start is
// any good.
double FirstStep(const FreeEntry& entry) {
  if (entry.kind == FreeEntry::Kind::kHandle) return 0.05;
  if (entry.is_log) return 0.5;
  return 0.5 * entry.prior_sigma;
}

// One simulation from the start with nothing in its way. The sum of the frames' errors; infinite
// where it does not reach the last one. `positions` may be null.
double OpenLoopError(const SynthesisError& error, int last, WindowSimulator* simulator,
                     const Eigen::VectorXd& theta, std::vector<Eigen::VectorXd>* positions) {
  double sum = 0.0;
  const auto outcome = simulator->Run(simulator->FirstStart(theta), theta, last, false,
                                      [&](int frame, const State& state, const Sensitivity*) {
                                        sum += error.OfFrame(frame, state.x);
                                        if (positions != nullptr) positions->push_back(state.x);
                                      });
  return outcome == WindowSimulator::Outcome::kComplete ? sum : kInfinity;
}

// One search, whichever it is.
class Searcher {
 public:
  Searcher(const Scene& scene, const FitConfig& config, const SearchOptions& options)
      : scene_(scene),
        config_(config),
        options_(options),
        free_(config, scene, MakeParameterTable()),
        error_(scene, config),
        judge_(scene, config, free_, options.attract, nullptr),
        ledger_(scene, options),
        start_(options.start.size() > 0 ? options.start : free_.start()),
        costs_(static_cast<std::size_t>(NumWorkers()), 0.0) {}

  SearchResult Run() {
    SearchResult result = config_.loops == Strategy::kTwoLoop   ? TwoLoops()
                          : config_.loops == Strategy::kOneLoop ? OneLoop()
                          : config_.optimiser == "lm"           ? ByFit()
                                                                : Joint();
    ledger_.Finish(&result);
    std::vector<Eigen::VectorXd> positions;
    result.open_loop_error = OpenLoopError(error_, scene_.last_fitted_frame, &judge_, result.theta,
                                           result.positions.empty() ? &positions : nullptr);
    if (result.positions.empty()) {
      result.error = result.open_loop_error;
      result.positions = std::move(positions);
    }
    return result;
  }

 private:
  SearchResult ByFit();
  SearchResult Joint();
  SearchResult TwoLoops();
  SearchResult OneLoop();

  // Minimises over some entries of the free vector without derivatives; the rest stays.
  Minimum MinimiseOver(
      const std::vector<int>& entries, const std::string& optimiser,
      const std::function<double(const Eigen::VectorXd& theta, int worker)>& value);
  int NumWorkers() const {
    return config_.optimiser == "pattern" ? std::max(1, options_.num_threads) : 1;
  }
  FrameByFrameOptions PassOptions(bool fabric) const {
    FrameByFrameOptions options;
    options.optimiser = config_.optimiser;
    options.fabric = fabric;
    options.attract = options_.attract;
    return options;
  }
  // A pattern search may have many values under way, each of which counts when it is taken, so that
  // the budget ends at the same one for any number of threads.
  void Spend(const FrameCounts& work, int worker) {
    if (config_.optimiser == "pattern") {
      costs_[static_cast<std::size_t>(worker)] = work.simulated;
      return;
    }
    ledger_.Spend(work.simulated, work.differentiated);
    if (ledger_.IsSpent()) stop_ = true;
  }
  bool TakeCost(double simulated) {
    ledger_.Spend(simulated, 0.0);
    return !ledger_.IsSpent();
  }
  struct Value {
    double error = 0.0;
    FrameCounts work;
  };
  // The error at theta, as the worker has evaluated it or as the journal has it.
  double Recalled(const Eigen::VectorXd& theta, int worker, const std::function<Value()>& evaluate,
                  bool* is_recalled = nullptr);
  void TakePass(FrameByFrameResult pass, SearchResult* result) const;
  // Of what was recalled: the pass is made for its paths, and not counted again.
  void TakeUnstoppedPass(const Eigen::VectorXd& theta, SearchResult* result) const;

  const Scene& scene_;
  const FitConfig& config_;
  const SearchOptions& options_;
  FreeParameters free_;
  SynthesisError error_;
  WindowSimulator judge_;
  SearchLedger ledger_;
  Eigen::VectorXd start_;
  std::vector<double> costs_;  // frames, of each worker's last value
  std::atomic<bool> stop_ = false;
  std::mutex journal_mutex_;
};

// The fit's own error is the soft one; what it is judged by is computed beside, off the clock.
SearchResult Searcher::ByFit() {
  double simulated = 0.0, differentiated = 0.0;
  const auto spend_up_to = [&](double all, double with_derivatives) {
    ledger_.Spend(all - simulated, with_derivatives - differentiated);
    simulated = all;
    differentiated = with_derivatives;
    if (ledger_.IsSpent()) stop_ = true;
  };
  FitCallbacks callbacks;
  callbacks.stop = &stop_;
  callbacks.log = options_.log;
  callbacks.progress = [&](const FitProgress& progress) {
    spend_up_to(progress.simulated_frames, progress.differentiated_frames);
  };
  callbacks.checkpoint = [&](const FitCheckpoint& checkpoint) {
    ledger_.OffTheClock([&] {
      ledger_.Improve(
          OpenLoopError(error_, scene_.last_fitted_frame, &judge_, checkpoint.theta, nullptr));
    });
  };
  const FitResult fit = RunFit(scene_, config_, callbacks);
  spend_up_to(fit.simulated_frames, fit.differentiated_frames);
  SearchResult result;
  result.theta = fit.theta;
  result.converged = fit.status == FitStatus::kConverged;
  result.reason = ToString(fit.status);
  return result;
}

Minimum Searcher::MinimiseOver(
    const std::vector<int>& entries, const std::string& optimiser,
    const std::function<double(const Eigen::VectorXd& theta, int worker)>& value) {
  Objective objective;
  objective.start = start_(entries);
  objective.lower = free_.lower()(entries);
  objective.upper = free_.upper()(entries);
  objective.step.resize(objective.start.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    objective.step[static_cast<Eigen::Index>(i)] =
        options_.step_scale * FirstStep(free_.entries()[entries[i]]);
  objective.num_workers = NumWorkers();
  const auto whole = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd theta = start_;
    theta(entries) = x;
    return theta;
  };
  objective.value = [&](const Eigen::VectorXd& x, int worker) { return value(whole(x), worker); };
  OptimiserOptions settings;
  settings.seed = options_.seed;
  settings.stop = &stop_;
  settings.under_way = options_.under_way;
  objective.cost = [&](int worker) { return costs_[static_cast<std::size_t>(worker)]; };
  settings.taken = [&](double cost) { return TakeCost(cost); };
  settings.improved = [&](const Eigen::VectorXd& x, double error, int) {
    if (ledger_.Improve(error) && options_.improved) options_.improved(whole(x));
  };
  Minimum minimum = Minimise(optimiser, objective, settings);
  minimum.x = whole(minimum.x);
  return minimum;
}

double Searcher::Recalled(const Eigen::VectorXd& theta, int worker,
                          const std::function<Value()>& evaluate, bool* is_recalled) {
  const std::string name = fmt::format("search by {}", config_.optimiser);
  std::optional<Eigen::VectorXd> known;
  {
    const std::lock_guard<std::mutex> lock(journal_mutex_);
    if (options_.journal != nullptr) known = options_.journal->Recall(name, theta);
  }
  if (is_recalled != nullptr) *is_recalled = known.has_value();
  const Value value = known ? Value{(*known)[0], {(*known)[1], (*known)[2]}} : evaluate();
  if (!known && options_.journal != nullptr && !stop_) {  // what is stopped may not be whole
    const std::lock_guard<std::mutex> lock(journal_mutex_);
    options_.journal->Add(
        name, theta, Eigen::Vector3d(value.error, value.work.simulated, value.work.differentiated));
  }
  Spend(value.work, worker);
  return value.error;
}

SearchResult Searcher::Joint() {
  std::vector<std::unique_ptr<WindowSimulator>> simulators;
  for (int w = 0; w < NumWorkers(); ++w) {
    simulators.push_back(
        std::make_unique<WindowSimulator>(scene_, config_, free_, options_.attract, nullptr));
  }
  const auto value = [&](const Eigen::VectorXd& theta, int worker) {
    return Recalled(theta, worker, [&] {
      WindowSimulator& simulator = *simulators[static_cast<std::size_t>(worker)];
      const double before = simulator.simulated_frames();
      const double error =
          OpenLoopError(error_, scene_.last_fitted_frame, &simulator, theta, nullptr);
      return Value{error, {simulator.simulated_frames() - before, 0.0}};
    });
  };
  std::vector<int> all(static_cast<std::size_t>(free_.size()));
  std::iota(all.begin(), all.end(), 0);
  const Minimum minimum =
      MinimiseOver(options_.fabric_only ? free_.Fabric() : all, config_.optimiser, value);
  SearchResult result;
  result.theta = minimum.x;
  result.converged = minimum.converged;
  result.reason = minimum.reason;
  return result;
}

void Searcher::TakePass(FrameByFrameResult pass, SearchResult* result) const {
  result->theta = free_.WithHandlePaths(pass.theta, scene_, pass.paths, kPathSigma);
  result->error = pass.error;
  result->positions = std::move(pass.positions);
}

void Searcher::TakeUnstoppedPass(const Eigen::VectorXd& theta, SearchResult* result) const {
  TakePass(FrameByFrame(scene_, config_, free_, PassOptions(false), nullptr).Run(theta), result);
}

SearchResult Searcher::TwoLoops() {
  std::vector<std::unique_ptr<FrameByFrame>> passes;
  for (int w = 0; w < NumWorkers(); ++w) {
    passes.push_back(
        std::make_unique<FrameByFrame>(scene_, config_, free_, PassOptions(false), &stop_));
  }
  SearchResult result;
  result.theta = start_;
  result.error = kInfinity;
  std::mutex mutex;
  std::optional<Eigen::VectorXd> best_recalled;  // the best pass, where it was not made now
  const auto value = [&](const Eigen::VectorXd& theta, int worker) {
    FrameByFrameResult pass;
    bool is_recalled = false;
    const double error = Recalled(
        theta, worker,
        [&] {
          pass = passes[static_cast<std::size_t>(worker)]->Run(theta);
          return Value{pass.complete ? pass.error : kInfinity,
                       {pass.simulated_frames, pass.differentiated_frames}};
        },
        &is_recalled);
    const std::lock_guard<std::mutex> lock(mutex);
    if (!(error < result.error)) return error;
    best_recalled.reset();
    if (is_recalled) {
      best_recalled = theta;
      result.error = error;
    } else {
      TakePass(std::move(pass), &result);
    }
    return error;
  };
  const std::vector<int> fabric = free_.Fabric();
  if (fabric.empty()) {
    ledger_.Improve(value(start_, 0));
    if (config_.optimiser == "pattern" && !TakeCost(costs_[0])) stop_ = true;
    if (best_recalled) TakeUnstoppedPass(*best_recalled, &result);
    result.converged = !stop_;
    result.reason = "one pass: the fabric is known";
    return result;
  }
  const std::string outside = config_.optimiser != "lm" ? config_.optimiser
                              : fabric.size() > 1       ? "bobyqa"
                                                        : "sbplx";
  const Minimum minimum = MinimiseOver(fabric, outside, value);
  // Of passes with equal errors, which one came first is a matter of chance.
  if (std::max(options_.under_way, NumWorkers()) > 1 && !stop_) {
    result.error = kInfinity;
    value(minimum.x, 0);
  }
  if (best_recalled) TakeUnstoppedPass(*best_recalled, &result);
  result.converged = minimum.converged;
  result.reason = minimum.reason;
  return result;
}

SearchResult Searcher::OneLoop() {
  FrameByFrame search(scene_, config_, free_, PassOptions(true), &stop_);
  FrameByFrameResult pass = search.Run(start_);
  ledger_.Spend(pass.simulated_frames, pass.differentiated_frames);
  SearchResult result;
  result.theta = start_;
  result.error = kInfinity;
  if (pass.complete) {
    ledger_.Improve(pass.error);
    TakePass(std::move(pass), &result);
  }
  result.converged = std::isfinite(result.error);
  result.reason = result.converged ? "one pass" : "the pass did not reach the last frame";
  return result;
}

}  // namespace

SearchResult Search(const Scene& scene, const FitConfig& config, const SearchOptions& options) {
  if (config.loops != Strategy::kJoint && config.optimiser == "direct") {
    throw InputError("optimiser", fmt::format("direct searches within bounds, which the handles of "
                                              "a frame do not have; {} expected another one",
                                              ToString(config.loops)));
  }
  return Searcher(scene, config, options).Run();
}

}  // namespace clothfit
