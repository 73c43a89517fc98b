// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a search has spent, by all its workers, and what it has found. Behind Search; nothing else
// includes it.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <vector>

#include "fitting/fit/search.h"

namespace clothfit {

class SearchLedger {
 public:
  SearchLedger(const Scene& scene, const SearchOptions& options)
      : options_(options),
        frames_(std::max(1, scene.last_fitted_frame)),
        begin_(std::chrono::steady_clock::now()) {}

  // Frames simulated, and how many of them with derivatives.
  void Spend(double simulated, double differentiated) {
    const std::lock_guard<std::mutex> lock(mutex_);
    simulations_ += (simulated + (options_.derivative_cost - 1.0) * differentiated) / frames_;
    if (options_.progress) options_.progress({simulations_, Seconds(), Best()});
  }
  // True where the error is the best so far.
  bool Improve(double error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!(error < Best())) return false;
    history_.push_back({simulations_, Seconds(), error});
    return true;
  }
  // What the work takes is not counted: it serves the ledger, not the search.
  template <class Work>
  void OffTheClock(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::lock_guard<std::mutex> lock(mutex_);
    begin_ += std::chrono::steady_clock::now() - begin;
  }
  bool IsSpent() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return simulations_ >= options_.budget.evaluations || Seconds() >= options_.budget.seconds ||
           (options_.stop != nullptr && *options_.stop);
  }
  void Finish(SearchResult* result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    result->history = history_;
    result->simulations = simulations_;
    result->seconds = Seconds();
  }

 private:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  double Best() const {
    return history_.empty() ? std::numeric_limits<double>::infinity() : history_.back().error;
  }

  const SearchOptions& options_;
  double frames_;  // of a simulation
  std::chrono::steady_clock::time_point begin_;
  std::mutex mutex_;
  double simulations_ = 0.0;
  std::vector<SearchPoint> history_;
};

}  // namespace clothfit
