// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A simulation as one Ceres cost function of one block of unknowns.
#pragma once

#include <functional>

#include <Eigen/Core>
#include <ceres/cost_function.h>

#include "fitting/optimise/row_major_matrix.h"

namespace clothfit {

// Levenberg-Marquardt asks for the residuals where it tries a step and, if it takes the step, for
// the Jacobian there. A motion that has been simulated need not be solved for again to be
// differentiated (Simulation::Advance), so a step that is not taken costs no derivatives and one
// that is taken costs no second simulation.
class SimulationCost final : public ceres::CostFunction {
 public:
  // Residuals at theta and, unless null, their Jacobian. False where there are none.
  using Evaluator = std::function<bool(const Eigen::VectorXd& theta, Eigen::VectorXd* residuals,
                                       RowMajorMatrix* jacobian)>;

  SimulationCost(int num_residuals, int num_unknowns, Evaluator evaluator);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Evaluator evaluator_;
  // What was computed last. Ceres evaluates one cost function from one thread at a time.
  mutable Eigen::VectorXd theta_, residuals_;
  mutable RowMajorMatrix jacobian_;
  mutable bool has_residuals_ = false, has_jacobian_ = false;
};

}  // namespace clothfit
