// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How Ceres' Levenberg-Marquardt is set up for simulations.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <ceres/iteration_callback.h>
#include <ceres/solver.h>

#include "fitting/optimise/simulation_cost.h"

namespace clothfit {

// At the first iteration: half a Gauss-Newton step, as the costs are rugged.
inline constexpr double kCautiousRadius = 1.0;

ceres::Solver::Options LevenbergMarquardtOptions(int max_iterations, double function_tolerance,
                                                 double first_radius = kCautiousRadius);

// When a minimisation has come to its end: a step that was taken lowers the cost by less than the
// tolerance, relative to it, and was not cut short by a small trust region; or so many steps in
// turn that were taken do, as where the cost is too rugged for the region to grow. (Ceres looks at
// steps that were not taken and at any radius.)
class EndOfDescent {
 public:
  // least_radius: of a trust region that cuts no step short.
  EndOfDescent(double tolerance, double least_radius, int in_turn)
      : tolerance_(tolerance), least_radius_(least_radius), in_turn_(in_turn) {}
  // Of iterations in their order; iteration 0 is where it begins.
  bool IsReached(const ceres::IterationSummary& iteration);

 private:
  double tolerance_, least_radius_;
  int in_turn_, small_steps_ = 0;  // in turn
};

// Where the unknowns may be; bounds may be infinite.
struct Bounds {
  Eigen::VectorXd lower, upper;
  std::vector<int> held;  // unknowns that stay as they are
};

// Minimises half the sum of squares of the residuals. A step ends at the bounds, and an unknown at
// a bound that its gradient leads beyond stays there for the next step.
ceres::Solver::Summary MinimiseWithin(const Bounds& bounds, int num_residuals,
                                      const SimulationCost::Evaluator& evaluate,
                                      const ceres::Solver::Options& options,
                                      Eigen::VectorXd* unknowns);

}  // namespace clothfit
