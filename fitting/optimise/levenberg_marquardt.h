// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How Ceres' Levenberg-Marquardt is set up for simulations.
#pragma once

#include <Eigen/Core>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace clothfit {

// At the first iteration: half a Gauss-Newton step, as the costs are rugged.
inline constexpr double kCautiousRadius = 1.0;

ceres::Solver::Options LevenbergMarquardtOptions(int max_iterations, double function_tolerance,
                                                 double first_radius = kCautiousRadius);

// Keeps a block of unknowns within these bounds, as far as they are finite.
void SetBounds(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double* unknowns,
               ceres::Problem* problem);

}  // namespace clothfit
