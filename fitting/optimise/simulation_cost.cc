// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/simulation_cost.h"

#include <utility>

namespace clothfit {

SimulationCost::SimulationCost(int num_residuals, int num_unknowns, Evaluator evaluator)
    : evaluator_(std::move(evaluator)) {
  set_num_residuals(num_residuals);
  mutable_parameter_block_sizes()->push_back(num_unknowns);
}

bool SimulationCost::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  const Eigen::Index columns = parameter_block_sizes()[0];
  const Eigen::Map<const Eigen::VectorXd> theta(parameters[0], columns);
  const bool is_asked = jacobians != nullptr && jacobians[0] != nullptr;
  const bool is_known = has_residuals_ && theta_ == theta;
  if (!is_known || (is_asked && !has_jacobian_)) {
    theta_ = theta;
    has_residuals_ = evaluator_(theta_, &residuals_, is_asked ? &jacobian_ : nullptr);
    has_jacobian_ = has_residuals_ && is_asked;
  }
  if (!has_residuals_) return false;
  Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = residuals_;
  if (is_asked) Eigen::Map<RowMajorMatrix>(jacobians[0], num_residuals(), columns) = jacobian_;
  return true;
}

}  // namespace clothfit
