// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One pattern search by many processes, as Kolda 2005 runs it: where a single fit is the work.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "fitting/optimise/optimiser.h"

namespace clothfit {

struct SharedSearchOptions {
  std::filesystem::path folder;  // of the ledger of points, the same for all processes
  double patience = 300.0;       // s, see JobRunOptions
  int worker = 0;                // tells the workers of one process apart
  // Points under way at a time: as many workers find work at most. Part of what decides the result.
  int slots = 16;
  // In the unit of `spent`: no point is planned where those whose values were taken cost as much.
  double most_spent = 1e300;
  double tolerance = 0.01;  // first steps
  const std::atomic<bool>* stop = nullptr;
  // What this process has spent so far, in any unit; empty: nobody counts.
  std::function<double()> spent;
  // Each new best, in the same order in all processes.
  std::function<void(const Eigen::VectorXd& x, double value)> improved;
  // Called with a function that gives signs of life while a point is evaluated, and with an empty
  // one after it.
  std::function<void(const std::function<void()>& alive)> evaluating;
};

struct SharedMinimum {
  Minimum minimum;
  double spent = 0.0;  // by all processes
};

// Every process calls this with the same objective and options, and gets the same result. Each runs
// the search itself; what they share is the values of points. There is no first among them: a
// process that dies or hangs loses the point it had in hand, and one that comes late finds the
// values that there are. Values are taken in the order in which the search planned the points, not
// in that in which they arrive, so that the course does not depend on who is how fast: it waits for
// nobody as long as the slots suffice. Of the objective, worker 0 alone is used.
SharedMinimum SearchPatternTogether(const Objective& objective, const SharedSearchOptions& options);

}  // namespace clothfit
