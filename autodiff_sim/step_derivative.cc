// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of a solved step.
#include <algorithm>

#include "autodiff_sim/step_solver.h"

namespace clothfit {
namespace {

// GMRES iterations of kLanes columns that are cheaper than another factorisation, about.
constexpr int kTooManySensitivityIterations = 20;

}  // namespace

// -dr along the lanes at fixed free velocities: M dv_hat + gamma (K dx_hat + df) - dM (v - v_hat).
Lanes<kLanes> StepSolver::RightHandSide(const StepProblem& problem,
                                        const Eigen::MatrixXd& parameter_directions,
                                        const StepInputs& inputs, const Eigen::VectorXd& v,
                                        int first_column, const StateLanes& lanes,
                                        const Lanes<kLanes>& dx_hat,
                                        const Lanes<kLanes>& dv_hat) const {
  const double gamma = problem.formula.gamma, density = (*problem.parameters)[kArealDensity];
  const int count =
      std::min<int>(kLanes, static_cast<int>(parameter_directions.cols()) - first_column);
  Lanes<kLanes> rhs(dx_hat.rows(), kLanes);
  for (std::size_t i = 0; i < model_->topology().areas.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    rhs.middleRows<3>(row) = density * model_->topology().areas[i] * dv_hat.middleRows<3>(row);
  }
  stiffness_.AddProduct<kLanes>(dx_hat, gamma, &rhs);
  for (Eigen::Index p = 0; p < parameter_directions.rows(); ++p) {
    for (int c = 0; c < count; ++c) {
      const double weight = parameter_directions(p, first_column + c);
      if (weight != 0.0) rhs.col(c) += gamma * weight * linearization_.by_parameter.col(p);
    }
  }
  for (int c = 0; c < count; ++c) {  // the mass itself
    const double weight = parameter_directions(kArealDensity, first_column + c);
    if (weight == 0.0) continue;
    for (std::size_t i = 0; i < model_->topology().areas.size(); ++i) {
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
      rhs.col(c).segment<3>(row) -= weight * model_->topology().areas[i] *
                                    (v.segment<3>(row) - problem.v_hat.segment<3>(row));
    }
  }
  if (inputs.directions.size() > 0) {
    for (const InputDerivative& d : linearization_.by_input) {
      rhs.block(3 * d.node, 0, 3, count) +=
          gamma * d.derivative * inputs.directions.row(d.input_row).segment(first_column, count);
    }
  }
  for (const MemoryElement& e : linearization_.with_memory) {
    const int forces = 3 * static_cast<int>(e.nodes.size());
    const int memory = static_cast<int>(e.jacobian.rows()) - forces;
    const Eigen::MatrixXd df =
        e.jacobian.topRightCorner(forces, memory) * lanes.memory.middleRows(e.first_memory, memory);
    for (std::size_t n = 0; n < e.nodes.size(); ++n) {
      rhs.middleRows<3>(3 * e.nodes[n]) += gamma * df.middleRows<3>(3 * static_cast<int>(n));
    }
  }
  return rhs;
}

// The new memory along the lanes, once the new positions and velocities are known.
void StepSolver::AdvanceMemory(const Eigen::MatrixXd& parameter_directions, int first_column,
                               StateLanes* lanes) const {
  const int count =
      std::min<int>(kLanes, static_cast<int>(parameter_directions.cols()) - first_column);
  for (const MemoryElement& e : linearization_.with_memory) {
    const int nodes = static_cast<int>(e.nodes.size()), forces = 3 * nodes;
    const int memory = static_cast<int>(e.jacobian.rows()) - forces;
    Eigen::MatrixXd direction = Eigen::MatrixXd::Zero(e.jacobian.cols(), kLanes);
    for (int n = 0; n < nodes; ++n) {
      direction.middleRows<3>(3 * n) = lanes->v.middleRows<3>(3 * e.nodes[n]);
      direction.middleRows<3>(forces + 3 * n) = lanes->x.middleRows<3>(3 * e.nodes[n]);
    }
    const int own = static_cast<int>(e.jacobian.cols()) - 2 * forces - 1 - memory;
    direction.block(2 * forces, 0, own, count) =
        parameter_directions.block(e.first_parameter, first_column, own, count);
    direction.block(2 * forces + own, 0, 1, count) =
        parameter_directions.block(kArealDensity, first_column, 1, count);
    direction.bottomRows(memory) = lanes->memory.middleRows(e.first_memory, memory);
    lanes->memory.middleRows(e.first_memory, memory) = e.jacobian.bottomRows(memory) * direction;
  }
}

bool StepSolver::Differentiate(const StepProblem& problem, const StepInputs& inputs,
                               const Eigen::VectorXd& v, Sensitivity* sensitivity,
                               StepReport* report) {
  const StepFormula& formula = problem.formula;
  const Eigen::MatrixXd& directions = sensitivity->parameters();
  std::vector<bool> wanted(static_cast<std::size_t>(directions.rows()));
  for (Eigen::Index p = 0; p < directions.rows(); ++p) wanted[p] = !directions.row(p).isZero(0.0);
  model_->Linearize(problem.end_time, problem.x_hat + formula.gamma * v, v, *problem.parameters,
                    problem.memory, formula.gamma, wanted, &linearization_);
  ++report->jacobians;
  // The right-hand sides need the Jacobian before the handles are taken out of it.
  std::vector<Lanes<kLanes>> dx_hat(sensitivity->lanes().size()), rhs(dx_hat.size()),
      held(dx_hat.size());
  for (std::size_t b = 0; b < dx_hat.size(); ++b) {
    StateLanes& lanes = sensitivity->lanes()[b];
    const int first = static_cast<int>(b) * kLanes;
    dx_hat[b] = formula.now * lanes.x + formula.before * lanes.previous_x;
    const Lanes<kLanes> dv_hat = formula.now * lanes.v + formula.before * lanes.previous_v;
    rhs[b] = RightHandSide(problem, directions, inputs, v, first, lanes, dx_hat[b], dv_hat);
    problem.constraints->DependentVelocityDerivative(inputs, first, dx_hat[b], formula.gamma,
                                                     &held[b]);
    if (!held[b].isZero(0.0)) jacobian_.AddProduct<kLanes>(held[b], -1.0, &rhs[b]);
    problem.constraints->ReduceResidual<kLanes>(&rhs[b]);
  }
  problem.constraints->ReduceMatrix(&jacobian_);
  jacobian_gamma_ = formula.gamma;
  factor_is_current_ = false;
  int slowest = 0;
  for (std::size_t b = 0; b < dx_hat.size(); ++b) {
    StateLanes& lanes = sensitivity->lanes()[b];
    const bool still = lanes.is_zero && rhs[b].isZero(0.0) && held[b].isZero(0.0);
    Lanes<kLanes> dv = Lanes<kLanes>::Zero(dx_hat[b].rows(), kLanes);
    if (!still) {
      // Extrapolated from the steps before: a first guess, whatever it is worth.
      dv = lanes.v;
      if (formula.before != 0.0) dv += lanes.v - lanes.previous_v;
      int iterations = 0;
      if (!SolveLanes(problem, rhs[b], &dv, &iterations, report)) return false;
      slowest = std::max(slowest, iterations);
      problem.constraints->ExpandDirection<kLanes>(&dv);
      dv += held[b];
    }
    lanes.previous_x = lanes.x;
    lanes.previous_v = lanes.v;
    lanes.x = dx_hat[b] + formula.gamma * dv;
    lanes.v = dv;
    lanes.is_zero = still;
    AdvanceMemory(directions, static_cast<int>(b) * kLanes, &lanes);
  }
  report->sensitivity_iterations += slowest;
  return true;
}

bool StepSolver::SolveLanes(const StepProblem& problem, const Lanes<kLanes>& rhs, Lanes<kLanes>* dv,
                            int* iterations, StepReport* report) {
  // The guess obeys the handles of this step: the held rows of the reduced system are zero.
  problem.constraints->ClearHeld(dv);
  GmresOptions options;
  options.relative_tolerance = options_.sensitivity_tolerance;
  options.max_iterations = factor_is_current_ ? 100 : kTooManySensitivityIterations;
  GmresReport linear = SolveGmres<kLanes>(jacobian_, &factor_, rhs, options, dv);
  *iterations += linear.iterations;
  if (linear.converged) return true;
  if (factor_is_current_ || !RefreshFactor(report)) return false;
  options.max_iterations = 100;
  linear = SolveGmres<kLanes>(jacobian_, &factor_, rhs, options, dv);
  *iterations += linear.iterations;
  return linear.converged;
}

}  // namespace clothfit
