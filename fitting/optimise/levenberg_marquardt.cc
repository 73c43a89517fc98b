// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/levenberg_marquardt.h"

#include <cmath>

namespace clothfit {

ceres::Solver::Options LevenbergMarquardtOptions(int max_iterations, double function_tolerance,
                                                 double first_radius) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = function_tolerance;
  options.parameter_tolerance = 1e-7;
  options.initial_trust_region_radius = first_radius;
  options.max_num_consecutive_invalid_steps = 20;  // a trial whose simulation diverges
  options.logging_type = ceres::SILENT;
  return options;
}

void SetBounds(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double* unknowns,
               ceres::Problem* problem) {
  for (int i = 0; i < static_cast<int>(lower.size()); ++i) {
    if (std::isfinite(lower[i])) problem->SetParameterLowerBound(unknowns, i, lower[i]);
    if (std::isfinite(upper[i])) problem->SetParameterUpperBound(unknowns, i, upper[i]);
  }
}

}  // namespace clothfit
