// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Asynchronous parallel pattern search (Kolda 2005, "Revisiting asynchronous parallel pattern
// search for nonlinear optimization", SIAM J. Optim. 16(2), algorithm 2): what Hasler et al. 2007
// searched with.
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "fitting/optimise/optimiser.h"

namespace clothfit {

struct PatternSearchOptions {
  double contraction = 0.5;
  double expansion = 2.0;   // of the steps after two improvements in a row along one direction
  double tolerance = 0.01;  // first steps; where all steps are shorter the search ends
  double sufficient_decrease = 1e-5;  // of the value at the start, times the step's square
};

// The search as a machine that gives points to evaluate and takes their values in whatever order
// they come: it waits for nobody. Two coordinate directions a dimension, each with a step of its
// own; a step that does not improve is contracted, an improvement moves the search at once and
// drops what was planned from the old place but not yet begun. Points outside the box are moved
// onto it, and no point is evaluated twice. Deterministic given the order of reports.
class PatternSearch {
 public:
  struct Trial {
    int id;
    Eigen::VectorXd x;
  };

  // `value` is the objective's at its start.
  PatternSearch(const Objective& objective, double value, const PatternSearchOptions& options);

  // The next point to evaluate; nothing where all that could be is under way, or the end is
  // reached.
  std::optional<Trial> Next();
  // The value of a trial that Next gave.
  void Report(int id, double value);

  // Every step is shorter than the tolerance, and nothing is under way.
  bool HasConverged() const;
  const Eigen::VectorXd& best() const { return best_; }
  double best_value() const { return best_value_; }
  int num_under_way() const { return static_cast<int>(under_way_.size()); }
  int num_from_cache() const { return num_from_cache_; }

 private:
  struct Planned {
    int id;
    Eigen::VectorXd x;
    int direction;   // 2k: along the k-th axis, 2k + 1: against it
    double step;     // first steps
    int generation;  // of the best point that it was made from
  };

  Eigen::VectorXd Step(int direction, double step) const;
  void Plan();
  void Take(const Planned& trial, double value);
  void Refuse(int direction);
  bool IsKnown(const Eigen::VectorXd& x) const;

  Eigen::VectorXd lower_, upper_, first_step_;
  PatternSearchOptions options_;
  double scale_;  // of values
  Eigen::VectorXd best_;
  double best_value_;
  int generation_ = 0, next_id_ = 0, num_from_cache_ = 0;
  int last_direction_ = -1;
  std::vector<double> steps_;     // by direction, in first steps
  std::vector<bool> is_planned_;  // by direction, from this generation's best
  std::deque<Planned> queue_;
  std::vector<Planned> under_way_;
  std::vector<Eigen::VectorXd> known_;  // all that was evaluated, in first steps
};

// Runs it on as many threads as the objective has workers. Values are taken in the order in which
// their points were planned, not in that in which they arrive: with as many points under way, the
// course is the same for any number of threads and whoever is fast.
Minimum SearchPattern(const Objective& objective, const OptimiserOptions& options);

}  // namespace clothfit
