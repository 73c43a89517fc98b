// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/shared_pattern_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/jobs/ledger.h"
#include "fitting/optimise/pattern_search.h"

namespace clothfit {
namespace {

constexpr std::chrono::milliseconds kShortestSharedPause(1),
    kLongestSharedPause(50);  // between looks at the folder

std::string NameOf(int id) { return fmt::format("point-{:06}", id); }

std::vector<double> AsList(const Eigen::VectorXd& x) { return {x.data(), x.data() + x.size()}; }

// Evaluates points and reads what others made of them.
class SharedPoints {
 public:
  SharedPoints(const Objective& objective, const SharedSearchOptions& options)
      : objective_(objective),
        options_(options),
        ledger_(options.folder, options.patience, options.worker) {}

  bool IsStopped() const { return options_.stop != nullptr && *options_.stop; }
  double spent() const { return spent_; }

  // The value of point `id`, once there is one.
  std::optional<double> Read(int id, const Eigen::VectorXd& x) {
    const std::optional<JobResult> result = ledger_.Read(NameOf(id));
    if (!result) return std::nullopt;
    if (!result->IsDone()) return std::numeric_limits<double>::infinity();
    if (result->output.at("x").get<std::vector<double>>() != AsList(x)) {
      throw InputError((options_.folder / (NameOf(id) + ".json")).string(),
                       "a point of another search");
    }
    spent_ += result->output.at("spent").get<double>();
    const nlohmann::json& value = result->output.at("value");
    return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  }

  // False where somebody else has it, or has done it.
  bool Evaluate(int id, const Eigen::VectorXd& x) {
    const std::string name = NameOf(id);
    if (ledger_.HasResult(name) || !ledger_.Take(name)) return false;
    if (options_.evaluating) options_.evaluating([&] { ledger_.Alive(name); });
    const double before = options_.spent ? options_.spent() : 0.0;
    const double value = objective_.value(x, 0);
    const double cost = options_.spent ? options_.spent() - before : 0.0;
    if (options_.evaluating) options_.evaluating({});
    // JSON has no word for infinity.
    const nlohmann::json json = std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
    if (!IsStopped())
      ledger_.Record({name, {{"x", AsList(x)}, {"value", json}, {"spent", cost}}, "", 0.0});
    ledger_.Release(name);
    return true;
  }

 private:
  const Objective& objective_;
  const SharedSearchOptions& options_;
  JobLedger ledger_;
  double spent_ = 0.0;
};

using Trials = std::deque<PatternSearch::Trial>;

// The value of the first of these, while others of them are evaluated here; nothing if stopped.
std::optional<double> Await(const Trials& trials, SharedPoints* points) {
  auto pause = kShortestSharedPause;
  while (!points->IsStopped()) {
    if (const auto value = points->Read(trials.front().id, trials.front().x)) return value;
    const bool has_worked = std::any_of(
        trials.begin(), trials.end(),
        [&](const PatternSearch::Trial& trial) { return points->Evaluate(trial.id, trial.x); });
    if (has_worked) {
      pause = kShortestSharedPause;
    } else {
      std::this_thread::sleep_for(pause);
      pause = std::min(kLongestSharedPause, 2 * pause);
    }
  }
  return std::nullopt;
}

}  // namespace

SharedMinimum SearchPatternTogether(const Objective& objective,
                                    const SharedSearchOptions& options) {
  SharedPoints points(objective, options);
  SharedMinimum result;
  constexpr int kStart = 999999;  // no trial has this number
  const std::optional<double> at_start = Await({{kStart, objective.start}}, &points);
  if (!at_start) {
    result.minimum.x = objective.start;
    result.minimum.value = std::numeric_limits<double>::infinity();
    result.minimum.reason = "stopped";
    return result;
  }
  PatternSearchOptions search_options;
  search_options.tolerance = options.tolerance;
  PatternSearch search(objective, *at_start, search_options);
  if (options.improved) options.improved(objective.start, *at_start);
  Trials under_way;
  int evaluations = 1;
  while (true) {
    while (static_cast<int>(under_way.size()) < options.slots &&
           points.spent() < options.most_spent) {
      const std::optional<PatternSearch::Trial> trial = search.Next();
      if (!trial) break;
      under_way.push_back(*trial);
      ++evaluations;
    }
    if (under_way.empty()) break;
    const std::optional<double> value = Await(under_way, &points);
    if (!value) break;
    const double before = search.best_value();
    search.Report(under_way.front().id, *value);
    under_way.pop_front();
    if (options.improved && search.best_value() < before)
      options.improved(search.best(), search.best_value());
  }
  const bool converged = search.HasConverged();
  result.minimum = {search.best(), search.best_value(), evaluations, converged,
                    converged            ? "all steps are shorter than the tolerance"
                    : points.IsStopped() ? "stopped"
                                         : "all its points are spent"};
  result.spent = points.spent();
  return result;
}

}  // namespace clothfit
