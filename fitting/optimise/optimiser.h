// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Optimisers behind one interface: what they minimise, what they may spend, what they found.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/optimise/row_major_matrix.h"

namespace clothfit {

// A function over a box, and where to begin.
struct Objective {
  Eigen::VectorXd start;
  Eigen::VectorXd lower, upper;  // may be infinite
  // Along each coordinate, a first step that matters: what derivative-free searches scale by.
  Eigen::VectorXd step;
  // The value; infinite or not a number where there is none. Calls may run at the same time, each
  // with a worker of its own from 0 to num_workers - 1.
  std::function<double(const Eigen::VectorXd& x, int worker)> value;
  int num_workers = 1;
  // What the worker's last value cost, in any unit; empty: nobody counts.
  std::function<double(int worker)> cost;
  // The value as half a sum of squares, with derivatives; empty where it has none, as the hard
  // silhouette error. As SimulationCost::Evaluator.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd* residuals,
                     RowMajorMatrix* jacobian)>
      residuals;
  int num_residuals = 0;
};

struct Budget {
  double evaluations = 1e300;  // of the value; of residuals, one with derivatives counts as one
  double seconds = 1e300;
};

struct Minimum {
  Eigen::VectorXd x;  // the best point evaluated
  double value = 0.0;
  int evaluations = 0;
  bool converged = false;  // by the optimiser's own criterion, rather than at the budget's end
  std::string reason;      // why it ended, in words
};

struct OptimiserOptions {
  Budget budget;
  double tolerance = 0.01;  // of derivative-free searches, in first steps; of others, see there
  unsigned seed = 1;        // of those that draw lots
  // Of pattern search: points that are evaluated at a time, which decides its course; at least one
  // a worker.
  int under_way = 1;
  // Of pattern search: called with the cost of each value as it is taken, one call at a time. False
  // plans no more points.
  std::function<bool(double cost)> taken;
  // Called with each new best, one call at a time; `evaluations` so far.
  std::function<void(const Eigen::VectorXd& x, double value, int evaluations)> improved;
  const std::atomic<bool>* stop = nullptr;
};

// One of OptimiserNames(): "lm" (Levenberg-Marquardt by Ceres, needs residuals), "pattern"
// (asynchronous pattern search after Kolda 2005), "annealing" (Corana et al. 1987), and of NLopt
// "bobyqa" (Powell 2009), "nelder-mead", "sbplx" (Rowan 1990) and "direct" (Gablonsky and Kelley
// 2001, global, within finite bounds). Throws InputError on another name, and where the objective
// lacks what the optimiser needs.
Minimum Minimise(const std::string& optimiser, const Objective& objective,
                 const OptimiserOptions& options);
const std::vector<std::string>& OptimiserNames();
bool NeedsDerivatives(const std::string& optimiser);

}  // namespace clothfit
