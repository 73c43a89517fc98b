// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Newton's method for one step.
#include "autodiff_sim/step_solver.h"

#include <cmath>

namespace clothfit {
namespace {

// GMRES iterations that are cheaper than another factorisation, about.
constexpr int kTooManyIterations = 14;
// With a factor of the matrix itself.
constexpr int kPatience = 60;
// Of a Newton direction: enough for the next iteration to be limited by the curvature instead.
constexpr double kForcingTerm = 1e-4;
// A Jacobian from an earlier iterate serves on while each iteration shrinks the error to less.
constexpr double kGoodContraction = 0.02;
constexpr double kShortestStep = 1e-4;

}  // namespace

StepSolver::StepSolver(ClothModel* model, const SimulationOptions& options)
    : model_(model),
      options_(options),
      position_tolerance_(options.tolerance * model->topology().mean_edge),
      jacobian_(&model->pattern()),
      stiffness_(&model->pattern()),
      factor_(&model->pattern()) {
  linearization_.step_jacobian = &jacobian_;
  linearization_.stiffness = &stiffness_;
}

void StepSolver::Reset() {
  factor_is_current_ = false;
  jacobian_gamma_ = 0.0;
  factor_.Forget();
}

const Eigen::VectorXd& StepSolver::Residual(const StepProblem& problem, const Eigen::VectorXd& v) {
  const double gamma = problem.formula.gamma;
  const Eigen::VectorXd x = problem.x_hat + gamma * v;
  model_->Forces(problem.end_time, x, v, *problem.parameters, problem.memory, &force_,
                 &new_memory_);
  full_residual_ = -gamma * force_;
  const double density = (*problem.parameters)[kArealDensity];
  for (std::size_t i = 0; i < model_->topology().areas.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    full_residual_.segment<3>(row) +=
        density * model_->topology().areas[i] * (v.segment<3>(row) - problem.v_hat.segment<3>(row));
  }
  reduced_residual_ = full_residual_;
  problem.constraints->ReduceResidual<1>(&reduced_residual_);
  return reduced_residual_;
}

void StepSolver::AssembleJacobian(const StepProblem& problem, const Eigen::VectorXd& v,
                                  StepReport* report) {
  const double gamma = problem.formula.gamma;
  model_->StepJacobian(problem.end_time, problem.x_hat + gamma * v, v, *problem.parameters,
                       problem.memory, gamma, &jacobian_);
  problem.constraints->ReduceMatrix(&jacobian_);
  jacobian_gamma_ = gamma;
  factor_is_current_ = false;
  ++report->jacobians;
}

bool StepSolver::RefreshFactor(StepReport* report) {
  const int before = factor_.num_factorizations();
  factor_is_current_ = factor_.Factorize(jacobian_);
  report->factorizations += factor_.num_factorizations() - before;
  return factor_is_current_;
}

bool StepSolver::Direction(Eigen::VectorXd* d, StepReport* report) {
  const Eigen::VectorXd rhs = -reduced_residual_;
  GmresOptions options;
  options.relative_tolerance = kForcingTerm;
  options.max_iterations = factor_is_current_ ? kPatience : kTooManyIterations;
  d->setZero(rhs.size());
  GmresReport linear = SolveGmres<1>(jacobian_, &factor_, rhs, options, d);
  report->linear_iterations += linear.iterations;
  if (!linear.converged && !factor_is_current_) {
    if (!RefreshFactor(report)) return false;
    options.max_iterations = kPatience;
    linear = SolveGmres<1>(jacobian_, &factor_, rhs, options, d);
    report->linear_iterations += linear.iterations;
  }
  return d->allFinite();  // where it is rough, the line search judges it
}

double StepSolver::LineSearch(const StepProblem& problem, const Eigen::VectorXd& d, double level,
                              Eigen::VectorXd* v, Eigen::VectorXd* z) {
  const Eigen::VectorXd start = *v;
  for (double share = 1.0; share >= kShortestStep; share *= 0.5) {
    *v = start + share * d;
    if (!Residual(problem, *v).allFinite()) continue;
    factor_.Solve<1>(reduced_residual_, z);
    if (z->norm() <= (1.0 - 0.25 * share) * level) return share;
  }
  *v = start;
  Residual(problem, *v);
  return 0.0;
}

bool StepSolver::Solve(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report) {
  const double gamma = problem.formula.gamma;
  problem.constraints->SetDependentVelocities(problem.x_hat, gamma, v);
  if (!Residual(problem, *v).allFinite()) return false;
  bool usable = jacobian_gamma_ == gamma, current = false;  // what jacobian_ is worth here
  if (!factor_.has_factor()) {
    AssembleJacobian(problem, *v, report);
    usable = current = true;
    if (!RefreshFactor(report)) return false;
  }
  Eigen::VectorXd z, d;
  factor_.Solve<1>(reduced_residual_, &z);
  for (int iteration = 0; gamma * z.lpNorm<Eigen::Infinity>() > position_tolerance_; ++iteration) {
    if (iteration == options_.max_newton_iterations) return false;
    ++report->newton_iterations;
    if (!usable) {
      AssembleJacobian(problem, *v, report);
      usable = current = true;
    }
    if (!Direction(&d, report)) return false;
    problem.constraints->ExpandDirection<1>(&d);
    factor_.Solve<1>(reduced_residual_, &z);  // the level in the metric of the present factor
    const double level = z.norm();
    const double share = LineSearch(problem, d, level, v, &z);
    if (share > 0.0) {
      current = false;
      usable = share == 1.0 && z.norm() < kGoodContraction * level;
    } else if (!current) {
      usable = false;
    } else if (factor_is_current_ || !RefreshFactor(report)) {
      return false;
    }
  }
  report->error = gamma * z.lpNorm<Eigen::Infinity>();
  return std::isfinite(report->error);
}

}  // namespace clothfit
