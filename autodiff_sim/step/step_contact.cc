// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How a step stays clear of contact: every iterate is reached from the one before on straight lines
// along which nothing meets (Li et al. 2020, "Incremental potential contact", sec. 4.3).
#include <utility>

#include "autodiff_sim/contact/contact_clock.h"
#include "autodiff_sim/step/step_solver.h"

namespace clothfit {

using Obstacles = ObstacleContacts::Obstacles;

bool StepSolver::StartClear(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report) {
  const Eigen::VectorXd &start = problem.start, &parameters = *problem.parameters;
  const double gamma = problem.formula.gamma;
  Eigen::VectorXd guess = problem.x_hat + gamma * *v;
  if (!guess.allFinite()) return false;
  model_->BeginContactStep(problem.end_time - problem.step, problem.end_time, parameters);
  model_->PrepareContacts(start, guess, parameters);
  double share = model_->FreeShare(start, guess, parameters, Obstacles::kMoving);
  if (share == 1.0) return true;
  ++report->limited_iterates;
  if (model_->ObstaclesMove()) {  // first the obstacles go, then the cloth
    if (model_->FreeShare(start, start, parameters, Obstacles::kMoving) < 1.0) {
      ++report->blocked_steps;
      return false;
    }
    share = model_->FreeShare(start, guess, parameters, Obstacles::kArrived);
  }
  const Eigen::VectorXd reached = start + share * (guess - start);
  *v = (reached - problem.x_hat) / gamma;
  problem.constraints->SetDependentVelocities(problem.x_hat, gamma, v);
  guess = problem.x_hat + gamma * *v;
  if (model_->FreeShare(reached, guess, parameters, Obstacles::kArrived) == 1.0) return true;
  ++report->blocked_steps;
  return false;
}

double StepSolver::ClearShare(const StepProblem& problem, const Eigen::VectorXd& v,
                              const Eigen::VectorXd& d, StepReport* report) {
  if (!problem.keep_clear) return 1.0;
  const double gamma = problem.formula.gamma;
  const Eigen::VectorXd x = problem.x_hat + gamma * v, end = x + gamma * d;
  if (!end.allFinite()) return 0.0;
  const double share = model_->FreeShare(x, end, *problem.parameters, Obstacles::kArrived);
  if (share < 1.0) ++report->limited_iterates;
  return share;
}

void StepSolver::PrepareContacts(const StepProblem& problem, const StepMotion& motion,
                                 StepReport* report) {
  model_->FollowContacts(motion.x, *problem.parameters);
  report->contact_pairs = model_->CountContacts()[0];
  report->obstacle_contacts = model_->CountContacts()[1];
  const ContactClock clock(&contact_times.response);
  if (model_->BindContacts()) return;
  model_->RebuildPattern();
  MakeMatrices(Ordering::kMinimumDegree);  // for some steps only
  ++report->pattern_rebuilds;
}

void StepSolver::MakeMatrices(Ordering ordering) {
  jacobian_ = BlockSparseMatrix(&model_->pattern());
  definite_ = BlockSparseMatrix(&model_->pattern());
  SparseCholesky factor(&model_->pattern(), ordering);
  factor.TakeShift(factor_);
  factor_ = std::move(factor);
  whole_.reset();
  stiffness_.reset();
  estimated_with_ = -1;
  gmres_ = Gmres(&model_->pattern());
  factor_is_current_ = false;
  excess_ = 0;
}

void StepSolver::ResetAll() {
  model_->ResetPattern();
  if (model_->has_self_contacts()) MakeMatrices(Ordering::kNestedDissection);
  Reset();
}

}  // namespace clothfit
