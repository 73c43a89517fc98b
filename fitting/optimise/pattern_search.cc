// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/pattern_search.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
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

Minimum SearchPattern(const Objective& objective, const OptimiserOptions& options) {
  const BudgetWatch watch(options);
  PatternSearchOptions search_options;
  search_options.tolerance = options.tolerance;
  const double at_start = objective.value(objective.start, 0);
  PatternSearch search(objective, at_start, search_options);
  if (options.improved) options.improved(objective.start, at_start, 1);
  int evaluations = 1;
  std::mutex mutex;
  std::condition_variable changed;
  std::exception_ptr failure;
  std::string reason;
  const auto spent = [&] {
    if (failure == nullptr && reason.empty()) reason = watch.Spent(evaluations);
    return failure != nullptr || !reason.empty();
  };
  const auto work = [&](int worker) {
    std::optional<InsideParallelWork> inside;
    if (objective.num_workers > 1) inside.emplace();
    std::unique_lock<std::mutex> lock(mutex);
    while (!spent() && !search.HasConverged()) {
      const std::optional<PatternSearch::Trial> trial = search.Next();
      if (!trial) {
        changed.wait(lock);
        continue;
      }
      ++evaluations;
      lock.unlock();
      double value = 0.0;
      std::exception_ptr own_failure;
      try {
        value = objective.value(trial->x, worker);
      } catch (...) {
        own_failure = std::current_exception();
      }
      lock.lock();
      if (own_failure != nullptr) {
        failure = own_failure;
      } else {
        const double before = search.best_value();
        search.Report(trial->id, value);
        if (options.improved && search.best_value() < before)
          options.improved(search.best(), search.best_value(), evaluations);
      }
      changed.notify_all();
    }
    changed.notify_all();
  };
  std::vector<std::thread> threads;
  for (int w = 1; w < objective.num_workers; ++w) threads.emplace_back(work, w);
  work(0);
  for (std::thread& thread : threads) thread.join();
  if (failure != nullptr) std::rethrow_exception(failure);
  const bool converged = search.HasConverged();
  return {search.best(), search.best_value(), evaluations, converged,
          converged ? "all steps are shorter than the tolerance" : reason};
}

}  // namespace clothfit
