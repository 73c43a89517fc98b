// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Intervals of parameters that the data tell little of, where a covariance misleads.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace clothfit {

// What is known of the free vector at the solution: half the cost is, to second order in the
// responses s(d) to offsets d from the solution,
//   1/2 s' A s + b' (s - d) + 1/2 d' Q d,
// which is least at d = 0. An entry on a linear scale responds by s = d. One on a log scale
// responds below the solution in proportion to the parameter itself, s = exp(d) - 1, since at zero
// its force is gone and no less can follow; above, in proportion to its logarithm, s = d, since
// much of a stiffness or a damping changes less than in proportion.
struct ResponseModel {
  Eigen::MatrixXd data_information;   // A = J' J over the noise's variance
  Eigen::VectorXd data_gradient;      // b = J' r over the same
  Eigen::MatrixXd prior_information;  // Q
  std::vector<bool> is_log;
};

struct Interval {
  double lower = 0.0, upper = 0.0;  // offsets from the solution, in the free vector's scale
};

// The profile interval of one entry (Venzon and Moolgavkar 1988): the offsets at which the cost,
// least over all other entries, has grown by half the square of `sigmas`. `covariance` is of the
// linearised problem, where the search starts.
Interval ProfileInterval(const ResponseModel& model, const Eigen::MatrixXd& covariance, int entry,
                         double sigmas);

}  // namespace clothfit
