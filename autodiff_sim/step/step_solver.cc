// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Newton's method for one step.
#include "autodiff_sim/step/step_solver.h"

#include <algorithm>
#include <cmath>

namespace clothfit {
namespace {

// GMRES iterations, at most, before another factor is tried, and with a factor of the matrix
// itself.
constexpr int kTooManyIterations = 14, kPatience = 60;
// What a fresh factor needs for a direction, and what a factorisation costs, in iterations.
constexpr int kIterationsOfFreshFactor = 4, kIterationsOfFactorization = 10;
// Relative tolerances of a Newton direction (Eisenstat and Walker 1996): as far as the next
// iteration is limited by the curvature instead, and, once a full step did not do, that of an exact
// direction.
constexpr double kForcingTerm = 0.01, kCarefulForcingTerm = 1e-4;
// Of what is needed for convergence: no direction is solved for more exactly than that.
constexpr double kLastShare = 0.3;
constexpr double kShortestStep = 1e-4;

}  // namespace

StepSolver::StepSolver(ClothModel* model, const SimulationOptions& options)
    : model_(model),
      options_(options),
      position_tolerance_(options.tolerance * model->topology().mean_edge),
      jacobian_(&model->pattern()),
      definite_(&model->pattern()),
      factor_(&model->pattern()),
      gmres_(&model->pattern()) {}

void StepSolver::Reset() {
  factor_is_current_ = false;
  excess_ = 0;
  estimated_with_ = -1;
  factor_.Forget();
}

const Eigen::VectorXd& StepSolver::Residual(const StepProblem& problem, const Eigen::VectorXd& v) {
  const double gamma = problem.formula.gamma;
  const StepMotion motion(problem, v);
  if (problem.keep_clear) model_->FollowContacts(motion.x, *problem.parameters);
  model_->Forces(motion.Point(problem), &force_, &new_memory_);
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
  const StepMotion motion(problem, v);
  if (problem.keep_clear) PrepareContacts(problem, motion, report);
  const double gamma = problem.formula.gamma;
  use_definite_ = model_->StepJacobian(motion.Point(problem), gamma, &jacobian_,
                                       problem.keep_clear ? &definite_ : nullptr);
  held_columns_ = problem.constraints->HeldColumns(jacobian_);
  problem.constraints->ReduceMatrix(&jacobian_);
  if (use_definite_) {
    model_->AddContactStiffness(motion.Point(problem), gamma, &definite_);
    problem.constraints->ReduceMatrix(&definite_);
  }
  gmres_.SetMatrix(&jacobian_);
  factor_is_current_ = false;
  ++report->jacobians;
}

bool StepSolver::FactorIsWorn(bool careful) const {
  return !factor_is_current_ && (careful || excess_ > kIterationsOfFactorization);
}

bool StepSolver::RefreshFactor(StepReport* report) {
  const int before = factor_.num_factorizations();
  factor_is_current_ = factor_.Factorize(use_definite_ ? definite_ : jacobian_);
  excess_ = 0;
  report->factorizations += factor_.num_factorizations() - before;
  return factor_is_current_;
}

StepSolver::Error StepSolver::EstimateError() {
  estimate_ = Preconditioned<1>(factor_, reduced_residual_);
  estimated_with_ = factor_.num_factorizations();
  const Eigen::VectorXd z = estimate_.scale[0] * estimate_.z.cast<double>();
  return {z.norm(), z.lpNorm<Eigen::Infinity>()};
}

bool StepSolver::Direction(double relative_tolerance, Eigen::VectorXd* d, StepReport* report) {
  const auto known = [this] {
    return estimated_with_ == factor_.num_factorizations() ? &estimate_ : nullptr;
  };
  GmresOptions options;
  options.relative_tolerance = relative_tolerance;
  options.max_iterations = factor_is_current_ ? kPatience : kTooManyIterations;
  d->setZero(reduced_residual_.size());
  GmresReport linear = gmres_.Solve<1>(&factor_, reduced_residual_, options, d, known());
  report->linear_iterations += linear.iterations;
  excess_ += std::max(0, linear.iterations - kIterationsOfFreshFactor);
  if (!linear.converged && !factor_is_current_) {
    if (!RefreshFactor(report)) return false;
    options.max_iterations = kPatience;
    linear = gmres_.Solve<1>(&factor_, reduced_residual_, options, d, known());
    report->linear_iterations += linear.iterations;
  }
  *d = -*d;
  return d->allFinite();  // where it is rough, the line search judges it
}

double StepSolver::LineSearch(const StepProblem& problem, const Eigen::VectorXd& d,
                              double largest_share, Eigen::VectorXd* v, Error* error) {
  const Eigen::VectorXd start = *v;
  const double level = error->norm;
  for (double share = largest_share; share >= kShortestStep * largest_share && share > 0.0;
       share *= 0.5) {
    *v = start + share * d;
    if (!Residual(problem, *v).allFinite()) continue;
    *error = EstimateError();
    if (error->norm <= (1.0 - 0.25 * share) * level) return share;
  }
  *v = start;
  Residual(problem, *v);
  *error = EstimateError();
  return 0.0;
}

bool StepSolver::Solve(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report) {
  const double gamma = problem.formula.gamma;
  problem.constraints->SetDependentVelocities(problem.x_hat, gamma, v);
  if (problem.keep_clear && !StartClear(problem, v, report)) return false;
  if (!Residual(problem, *v).allFinite()) return false;
  AssembleJacobian(problem, *v, report);
  if (!factor_.has_factor() && !RefreshFactor(report)) return false;
  bool current = true, usable = true;  // jacobian_: is that of v, serves at v
  double share = 1.0;
  Eigen::VectorXd d;
  Error error = EstimateError();
  for (int iteration = 0; gamma * error.largest > position_tolerance_; ++iteration) {
    if (iteration == options_.max_newton_iterations) return false;
    ++report->newton_iterations;
    if (!usable) {
      AssembleJacobian(problem, *v, report);
      usable = current = true;
      if (!factor_.has_factor() && !RefreshFactor(report)) return false;
    }
    const bool careful = share < 1.0;
    if (current && FactorIsWorn(careful) && !RefreshFactor(report)) return false;
    const double forcing = careful ? kCarefulForcingTerm : kForcingTerm;
    const double needed = kLastShare * position_tolerance_ / (gamma * error.largest);
    if (!Direction(std::max(forcing, needed), &d, report)) return false;
    problem.constraints->ExpandDirection<1>(&d);
    // The level in the metric of the present factor.
    if (estimated_with_ != factor_.num_factorizations()) error = EstimateError();
    const double level = error.norm, clear = ClearShare(problem, *v, d, report);
    share = LineSearch(problem, d, clear, v, &error);
    if (share > 0.0) {
      const double contraction = error.norm / level;
      current = false;
      // Another Jacobian costs about as much as an iteration.
      usable =
          share == 1.0 && contraction * contraction * gamma * error.largest < position_tolerance_;
    } else if (!current) {
      usable = false;
    } else if (factor_is_current_ || !RefreshFactor(report)) {
      return false;
    }
  }
  report->error = gamma * error.largest;
  UpdateMemoryOfOff(problem, *v);
  return std::isfinite(report->error);
}

void StepSolver::Take(const StepProblem& problem, const Eigen::VectorXd& v) {
  Residual(problem, v);
  UpdateMemoryOfOff(problem, v);
}

void StepSolver::UpdateMemoryOfOff(const StepProblem& problem, const Eigen::VectorXd& v) {
  const std::vector<bool> awake(model_->num_terms(), options_.remember_when_off);
  model_->UpdateMemoryOfOff(StepMotion(problem, v).Point(problem), awake, &new_memory_);
}

}  // namespace clothfit
