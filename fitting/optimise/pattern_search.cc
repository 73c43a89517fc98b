// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/pattern_search.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include "autodiff_sim/base/parallel.h"
#include "fitting/optimise/evaluation_counter.h"

namespace clothfit {

PatternSearch::PatternSearch(const Objective& objective, double value,
                             const PatternSearchOptions& options)
    : lower_(objective.lower),
      upper_(objective.upper),
      first_step_(objective.step),
      options_(options),
      scale_(std::isfinite(value) ? std::abs(value) : 1.0),
      best_(objective.start),
      best_value_(std::isnan(value) ? std::numeric_limits<double>::infinity() : value),
      steps_(2 * static_cast<std::size_t>(best_.size()), 1.0),
      is_planned_(steps_.size(), false) {
  known_.push_back(best_.cwiseQuotient(first_step_));
  Plan();
}

Eigen::VectorXd PatternSearch::Step(int direction, double step) const {
  Eigen::VectorXd x = best_;
  const int axis = direction / 2;
  x[axis] += (direction % 2 == 0 ? step : -step) * first_step_[axis];
  x[axis] = std::clamp(x[axis], lower_[axis], upper_[axis]);
  return x;
}

bool PatternSearch::IsKnown(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd scaled = x.cwiseQuotient(first_step_);
  return std::any_of(known_.begin(), known_.end(), [&](const Eigen::VectorXd& known) {
    return (known - scaled).lpNorm<Eigen::Infinity>() < 1e-3 * options_.tolerance;
  });
}

void PatternSearch::Refuse(int direction) {
  steps_[direction] *= options_.contraction;
  is_planned_[direction] = false;
}

// Plans a trial along every direction that has none, the one that led here first. What is known
// already is refused at once, if it is no better; it cannot be better, or it would be the best.
void PatternSearch::Plan() {
  std::vector<int> order;
  if (last_direction_ >= 0) order.push_back(last_direction_);
  for (int d = 0; d < static_cast<int>(steps_.size()); ++d) {
    if (d != last_direction_) order.push_back(d);
  }
  for (const int d : order) {
    while (!is_planned_[d] && steps_[d] >= options_.tolerance) {
      Eigen::VectorXd x = Step(d, steps_[d]);
      if (x == best_) {  // at the bound
        steps_[d] = 0.0;
      } else if (IsKnown(x)) {
        ++num_from_cache_;
        Refuse(d);
      } else {
        is_planned_[d] = true;
        queue_.push_back({next_id_++, std::move(x), d, steps_[d], generation_});
      }
    }
  }
}

std::optional<PatternSearch::Trial> PatternSearch::Next() {
  if (queue_.empty()) return std::nullopt;
  under_way_.push_back(std::move(queue_.front()));
  queue_.pop_front();
  return Trial{under_way_.back().id, under_way_.back().x};
}

void PatternSearch::Report(int id, double value) {
  const auto place = std::find_if(under_way_.begin(), under_way_.end(),
                                  [id](const Planned& p) { return p.id == id; });
  if (place == under_way_.end()) return;
  const Planned trial = std::move(*place);
  under_way_.erase(place);
  if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  known_.push_back(trial.x.cwiseQuotient(first_step_));
  const double decrease = options_.sufficient_decrease * scale_ * trial.step * trial.step;
  const bool is_better =
      std::isinf(best_value_) ? value < best_value_ : value < best_value_ - decrease;
  if (is_better) {
    Take(trial, value);
  } else if (trial.generation == generation_) {
    Refuse(trial.direction);
  }
  Plan();
}

void PatternSearch::Take(const Planned& trial, double value) {
  const bool again = trial.direction == last_direction_;
  best_ = trial.x;
  best_value_ = value;
  ++generation_;
  last_direction_ = trial.direction;
  queue_.clear();
  const double step = trial.step * (again ? options_.expansion : 1.0);
  std::fill(steps_.begin(), steps_.end(), std::max(step, 2.0 * options_.tolerance));
  std::fill(is_planned_.begin(), is_planned_.end(), false);
}

bool PatternSearch::HasConverged() const { return queue_.empty() && under_way_.empty(); }

namespace {

// A point under way, or one whose value waits for those before it.
struct PointUnderWay {
  PatternSearch::Trial trial;
  bool is_taken_up = false, has_value = false;
  double value = 0.0, cost = 0.0;
};

// The search by several threads. Every member is used under the mutex, but for the values.
class ThreadedSearch {
 public:
  ThreadedSearch(const Objective& objective, const OptimiserOptions& options)
      : objective_(objective),
        options_(options),
        watch_(options),
        at_start_(objective.value(objective.start, 0)),
        search_(objective, at_start_, WithTolerance(options.tolerance)) {
    TellCost(objective.cost ? objective.cost(0) : 0.0);
    if (options.improved) options.improved(objective.start, at_start_, 1);
  }

  Minimum Run() {
    std::vector<std::thread> threads;
    for (int w = 1; w < objective_.num_workers; ++w) threads.emplace_back([this, w] { Work(w); });
    Work(0);
    for (std::thread& thread : threads) thread.join();
    if (failure_ != nullptr) std::rethrow_exception(failure_);
    const bool converged = search_.HasConverged();
    return {search_.best(), search_.best_value(), evaluations_, converged,
            converged ? "all steps are shorter than the tolerance" : reason_};
  }

 private:
  static PatternSearchOptions WithTolerance(double tolerance) {
    PatternSearchOptions options;
    options.tolerance = tolerance;
    return options;
  }
  bool IsAborted() const {
    return failure_ != nullptr || (options_.stop != nullptr && *options_.stop);
  }
  void TellCost(double cost) {
    if (options_.taken && !options_.taken(cost)) reason_ = "stopped";
  }

  void Plan() {
    const auto slots =
        static_cast<std::size_t>(std::max(options_.under_way, objective_.num_workers));
    while (under_way_.size() < slots) {
      if (reason_.empty()) reason_ = watch_.Spent(evaluations_);
      if (!reason_.empty()) return;
      const std::optional<PatternSearch::Trial> trial = search_.Next();
      if (!trial) return;
      ++evaluations_;
      under_way_.push_back({*trial});
    }
  }

  // Those at the front whose values are there.
  void TakeValues() {
    while (!under_way_.empty() && under_way_.front().has_value) {
      const PointUnderWay point = std::move(under_way_.front());
      under_way_.pop_front();
      TellCost(point.cost);
      const double before = search_.best_value();
      search_.Report(point.trial.id, point.value);
      if (options_.improved && search_.best_value() < before)
        options_.improved(search_.best(), search_.best_value(), evaluations_);
      Plan();
    }
  }

  void Evaluate(PointUnderWay* point, int worker, std::unique_lock<std::mutex>* lock) {
    point->is_taken_up = true;
    lock->unlock();
    std::exception_ptr failure;
    double value = 0.0;
    try {
      value = objective_.value(point->trial.x, worker);
    } catch (...) {
      failure = std::current_exception();
    }
    const double cost = objective_.cost ? objective_.cost(worker) : 0.0;
    lock->lock();
    if (failure != nullptr) failure_ = failure;
    point->value = value;
    point->cost = cost;
    point->has_value = true;
  }

  void Work(int worker) {
    std::optional<InsideParallelWork> inside;
    if (objective_.num_workers > 1) inside.emplace();
    std::unique_lock<std::mutex> lock(mutex_);
    Plan();
    while (!IsAborted() && !under_way_.empty()) {
      const auto open = std::find_if(under_way_.begin(), under_way_.end(),
                                     [](const PointUnderWay& point) { return !point.is_taken_up; });
      if (open == under_way_.end()) {
        changed_.wait(lock);
        continue;
      }
      Evaluate(&*open, worker, &lock);
      if (!IsAborted()) TakeValues();
      changed_.notify_all();
    }
    if (IsAborted() && reason_.empty()) reason_ = "stopped";
    changed_.notify_all();
  }

  const Objective& objective_;
  const OptimiserOptions& options_;
  BudgetWatch watch_;
  double at_start_;
  PatternSearch search_;
  std::list<PointUnderWay> under_way_;  // in the order in which they were planned
  std::mutex mutex_;
  std::condition_variable changed_;
  std::exception_ptr failure_;
  std::string reason_;
  int evaluations_ = 1;
};

}  // namespace

Minimum SearchPattern(const Objective& objective, const OptimiserOptions& options) {
  return ThreadedSearch(objective, options).Run();
}

}  // namespace clothfit
