// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What optimisers keep: what is left of the budget and, of sequential ones, the best point so far.
#pragma once

#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "fitting/optimise/optimiser.h"

namespace clothfit {

// Begins with its construction.
class BudgetWatch {
 public:
  explicit BudgetWatch(const OptimiserOptions& options)
      : options_(options), begin_(std::chrono::steady_clock::now()) {}

  // Why to end after so many evaluations; empty while there is no reason to.
  std::string Spent(int evaluations) const {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
    if (options_.stop != nullptr && *options_.stop) return "stopped";
    if (evaluations >= options_.budget.evaluations) return "evaluations used up";
    if (seconds.count() >= options_.budget.seconds) return "time used up";
    return "";
  }

 private:
  const OptimiserOptions& options_;
  std::chrono::steady_clock::time_point begin_;
};

class EvaluationCounter {
 public:
  EvaluationCounter(const Objective& objective, const OptimiserOptions& options)
      : objective_(objective), options_(options), watch_(options) {
    minimum_.x = objective.start;
    minimum_.value = std::numeric_limits<double>::infinity();
  }

  // The objective's value, counted; infinite where it is not a number.
  double Value(const Eigen::VectorXd& x) {
    const double value = objective_.value(x, 0);
    Count(x, value);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }
  // Counts a value that was computed otherwise.
  void Count(const Eigen::VectorXd& x, double value) {
    ++minimum_.evaluations;
    if (!(value < minimum_.value)) return;
    minimum_.x = x;
    minimum_.value = value;
    if (options_.improved) options_.improved(x, value, minimum_.evaluations);
  }

  // Why to end now; empty while there is no reason to.
  std::string Spent() const { return watch_.Spent(minimum_.evaluations); }

  const Minimum& best() const { return minimum_; }
  Minimum Finish(bool converged, const std::string& reason) const {
    Minimum result = minimum_;
    result.converged = converged;
    result.reason = reason;
    return result;
  }

 private:
  const Objective& objective_;
  const OptimiserOptions& options_;
  BudgetWatch watch_;
  Minimum minimum_;
};

}  // namespace clothfit
