// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How a step stays clear of contact: every iterate is reached from the one before on straight lines
// along which nothing meets (Li et al. 2020, "Incremental potential contact", sec. 4.3).
#include <utility>

#include "autodiff_sim/step_solver.h"

namespace clothfit {

bool StepSolver::StartClear(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report) {
  const Eigen::VectorXd& start = problem.start;
  const double gamma = problem.formula.gamma;
  const double thickness = model_->ContactThickness(*problem.parameters);
  SelfContacts& contacts = *model_->contacts();
  Eigen::VectorXd guess = problem.x_hat + gamma * *v;
  if (!guess.allFinite()) return false;
  contacts.Prepare(start, guess, thickness);
  const double share = contacts.FreeShare(start, guess, thickness);
  if (share == 1.0) return true;
  ++report->limited_iterates;
  const Eigen::VectorXd reached = start + share * (guess - start);
  *v = (reached - problem.x_hat) / gamma;
  problem.constraints->SetDependentVelocities(problem.x_hat, gamma, v);
  guess = problem.x_hat + gamma * *v;
  if (contacts.FreeShare(reached, guess, thickness) == 1.0) return true;
  ++report->blocked_steps;
  return false;
}

double StepSolver::ClearShare(const StepProblem& problem, const Eigen::VectorXd& v,
                              const Eigen::VectorXd& d, StepReport* report) {
  if (!problem.keep_clear) return 1.0;
  const double gamma = problem.formula.gamma;
  const Eigen::VectorXd x = problem.x_hat + gamma * v, end = x + gamma * d;
  if (!end.allFinite()) return 0.0;
  const double thickness = model_->ContactThickness(*problem.parameters);
  const double share = model_->contacts()->FreeShare(x, end, thickness);
  if (share < 1.0) ++report->limited_iterates;
  return share;
}

void StepSolver::PrepareContacts(const StepProblem& problem, const StepMotion& motion,
                                 StepReport* report) {
  report->contact_pairs = model_->FollowContacts(motion.x, *problem.parameters);
  if (model_->BindContacts()) return;
  model_->RebuildPattern();
  MakeMatrices(Ordering::kMinimumDegree);  // for some steps only
  ++report->pattern_rebuilds;
}

void StepSolver::MakeMatrices(Ordering ordering) {
  jacobian_ = BlockSparseMatrix(&model_->pattern());
  SparseCholesky factor(&model_->pattern(), ordering);
  factor.TakeShift(factor_);
  factor_ = std::move(factor);
  gmres_ = Gmres(&model_->pattern());
  factor_is_current_ = false;
  excess_ = 0;
}

void StepSolver::ResetAll() {
  if (model_->contacts() != nullptr) {
    model_->ResetPattern();
    MakeMatrices(Ordering::kNestedDissection);
  }
  Reset();
}

}  // namespace clothfit
