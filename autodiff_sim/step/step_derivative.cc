// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of a solved step.
#include <algorithm>
#include <utility>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/linear/direct_solve.h"
#include "autodiff_sim/step/step_solver.h"

namespace clothfit {
namespace {

// An iteration of kLanes columns in iterations of one.
constexpr int kCostOfLanes = 3;
// Fewer than a fresh factor needs: it serves the next step too.
constexpr int kIterationsForNothing = 5;
constexpr int kTooManyDerivativeIterations = 25, kDerivativePatience = 100;

// Nothing has moved along any direction of the block so far, and nothing does now.
bool IsIdle(const Sensitivity& sensitivity, const StepInputs& inputs, std::size_t block) {
  if (!sensitivity.lanes()[block].is_zero) return false;
  const auto is_zero = [first = static_cast<Eigen::Index>(block) *
                                kLanes](const Eigen::MatrixXd& directions) {
    const Eigen::Index count = std::min<Eigen::Index>(kLanes, directions.cols() - first);
    return count <= 0 || directions.middleCols(first, count).isZero(0.0);
  };
  return is_zero(sensitivity.parameters()) && is_zero(inputs.directions);
}

}  // namespace

// While the step's free velocities stand still.
ForceDirections StepSolver::DirectionsAtFixedVelocity(const StepProblem& problem,
                                                      const StepInputs& inputs,
                                                      const Sensitivity& sensitivity,
                                                      std::size_t block) const {
  const StepFormula& formula = problem.formula;
  const StateLanes& lanes = sensitivity.lanes()[block];
  const int first = static_cast<int>(block) * kLanes;
  const auto take = [first](const Eigen::MatrixXd& all, Lanes<kLanes>* some) {
    some->setZero(all.rows(), kLanes);
    const int count = std::min<int>(kLanes, static_cast<int>(all.cols()) - first);
    if (count > 0) some->leftCols(count) = all.middleCols(first, count);
  };
  ForceDirections directions;
  take(sensitivity.parameters(), &directions.parameters);
  take(inputs.directions, &directions.inputs);
  directions.memory = &lanes.memory;
  directions.start = &lanes.x;
  directions.x = formula.now * lanes.x + formula.before * lanes.previous_x;
  problem.constraints->DependentVelocityDerivative(inputs, first, directions.x, formula.gamma,
                                                   &directions.v);
  directions.a =
      (formula.now * lanes.v + formula.before * lanes.previous_v) * (-1.0 / formula.gamma);
  return directions;
}

// -dr along these directions: gamma df - M gamma da - dM (v - v_hat), where df is of the positions
// K dx, of the held particles' velocities what the Jacobian says, and else by automatic
// differentiation.
Lanes<kLanes> StepSolver::RightHandSide(const StepProblem& problem, const Eigen::VectorXd& v,
                                        const ForceDirections& directions,
                                        const std::vector<bool>& awake) const {
  const StepFormula& formula = problem.formula;
  const double density = (*problem.parameters)[kArealDensity];
  Lanes<kLanes> rhs = Lanes<kLanes>::Zero(v.size(), kLanes);
  ForceDirections others;
  others.a = directions.a;
  others.parameters = directions.parameters;
  others.start = directions.start;
  others.memory = directions.memory;
  others.inputs = directions.inputs;
  const StepMotion motion(problem, v);
  model_->AddForceDerivatives(motion.Point(problem), others, awake, &rhs);
  stiffness_->AddProduct<kLanes>(directions.x, 1.0, &rhs);
  const Eigen::Matrix<double, 1, kLanes> density_lanes = directions.parameters.row(kArealDensity);
  for (Eigen::Index row = 0; row < rhs.rows(); ++row) {
    const double area = model_->topology().areas[static_cast<std::size_t>(row / 3)];
    rhs.row(row) = formula.gamma * (rhs.row(row) - density * area * directions.a.row(row)) -
                   area * (v[row] - problem.v_hat[row]) * density_lanes;
  }
  for (const HandleConstraints::HeldBlock& held : held_columns_) {
    rhs.middleRows<3>(3 * held.row) -= held.value * directions.v.middleRows<3>(3 * held.column);
  }
  problem.constraints->ReduceResidual<kLanes>(&rhs);
  return rhs;
}

bool StepSolver::Differentiate(const StepProblem& problem, const StepInputs& inputs,
                               const Eigen::VectorXd& v, Sensitivity* sensitivity,
                               StepReport* report) {
  AssembleJacobian(problem, v, report);
  if (!stiffness_) stiffness_.emplace(&model_->pattern());
  model_->Stiffness(StepMotion(problem, v).Point(problem), &*stiffness_);
  const int count = static_cast<int>(sensitivity->lanes().size());
  bool is_idle = true;
  for (int b = 0; b < count; ++b)
    is_idle = is_idle && IsIdle(*sensitivity, inputs, static_cast<std::size_t>(b));
  use_whole_ = !is_idle && FactorWhole(report);
  const bool is_worn = FactorIsWorn(false) || !factor_.has_factor();
  if (!use_whole_ && is_worn && !RefreshFactor(report)) return false;
  const std::vector<bool> awake = model_->Awake(*problem.parameters, sensitivity->parameters());
  model_->UpdateMemoryOfOff(StepMotion(problem, v).Point(problem), awake, &new_memory_);
  std::vector<LanesStep> steps(static_cast<std::size_t>(count));
  int done = 0;
  // The first that needs it finds out whether the factor is good enough, unless it is of now; then
  // the others at once.
  for (bool is_tried = use_whole_; done < count && !is_tried; ++done) {
    LanesStep& step = steps[static_cast<std::size_t>(done)];
    step = BeginLanes(problem, inputs, v, awake, *sensitivity, static_cast<std::size_t>(done));
    is_tried = !step.is_idle && !step.is_still;
    if (is_tried && !step.is_solved && !SolveStubbornLanes(&step, report)) return false;
  }
  ParallelFor(count - done, NumThreads(options_.num_threads), [&](int i, int) {
    const auto b = static_cast<std::size_t>(done + i);
    steps[b] = BeginLanes(problem, inputs, v, awake, *sensitivity, b);
  });
  int slowest = 0;
  for (LanesStep& step : steps) {
    if (step.is_idle || step.is_still) continue;
    if (!step.is_solved && !SolveStubbornLanes(&step, report)) return false;
    slowest = std::max(slowest, step.iterations);
    if (use_whole_) continue;
    excess_ += kCostOfLanes * std::max(0, step.iterations - kIterationsForNothing);
  }
  report->sensitivity_iterations += slowest;
  ParallelFor(count, NumThreads(options_.num_threads), [&](int i, int) {
    const auto b = static_cast<std::size_t>(i);
    if (!steps[b].is_idle) FinishLanes(problem, v, awake, &steps[b], &sensitivity->lanes()[b]);
  });
  return true;
}

StepSolver::LanesStep StepSolver::BeginLanes(const StepProblem& problem, const StepInputs& inputs,
                                             const Eigen::VectorXd& v,
                                             const std::vector<bool>& awake,
                                             const Sensitivity& sensitivity,
                                             std::size_t block) const {
  LanesStep step;
  step.is_idle = IsIdle(sensitivity, inputs, block);
  if (step.is_idle) return step;
  const StateLanes& lanes = sensitivity.lanes()[block];
  step.directions = DirectionsAtFixedVelocity(problem, inputs, sensitivity, block);
  step.rhs = RightHandSide(problem, v, step.directions, awake);
  step.is_still = lanes.is_zero && step.rhs.isZero(0.0) && step.directions.v.isZero(0.0);
  if (step.is_still) return step;
  // Extrapolated from the steps before: a first guess, whatever it is worth.
  step.dv = lanes.v;
  if (problem.formula.before != 0.0) step.dv += lanes.v - lanes.previous_v;
  // It obeys the handles of this step: the held rows of the reduced system are zero.
  problem.constraints->ClearHeld(&step.dv);
  step.is_solved = SolveLanes(&step).converged;
  return step;
}

bool StepSolver::FactorWhole(StepReport* report) {
  if (!whole_) whole_.emplace(factor_.supernodes());
  ++report->factorizations;
  return whole_->Factorize(jacobian_);
}

GmresReport StepSolver::SolveLanes(LanesStep* step) const {
  const SupernodalFactor* factor = &factor_;
  if (use_whole_) factor = &*whole_;
  GmresOptions options;
  options.relative_tolerance = options_.sensitivity_tolerance;
  options.factor_is_exact = use_whole_;
  options.max_iterations =
      SolvesWithFactorOfNow() ? kDerivativePatience : kTooManyDerivativeIterations;
  const GmresReport linear = gmres_.Solve<kLanes>(factor, step->rhs, options, &step->dv);
  step->iterations += linear.iterations;
  return linear;
}

bool StepSolver::SolveStubbornLanes(LanesStep* step, StepReport* report) {
  // The factor may have become another one since the try.
  if (SolvesWithFactorOfNow() ? step->iterations < kDerivativePatience : RefreshFactor(report))
    step->is_solved = SolveLanes(step).converged;
  if (step->is_solved) return true;
  ++report->factorizations;
  step->is_solved = SolveDirectly<kLanes>(jacobian_, step->rhs, &step->dv);
  return step->is_solved;
}

void StepSolver::FinishLanes(const StepProblem& problem, const Eigen::VectorXd& v,
                             const std::vector<bool>& awake, LanesStep* step,
                             StateLanes* lanes) const {
  ForceDirections& directions = step->directions;
  if (!step->is_still) {
    problem.constraints->ExpandDirection<kLanes>(&step->dv);
    directions.v += step->dv;
    directions.x += problem.formula.gamma * directions.v;
    directions.a += directions.v * (1.0 / problem.formula.gamma);
  }
  // Along what is known only now.
  model_->UpdateMemoryDerivatives(StepMotion(problem, v).Point(problem), directions, awake,
                                  &lanes->memory);
  lanes->previous_x = std::exchange(lanes->x, std::move(directions.x));
  lanes->previous_v = std::exchange(lanes->v, std::move(directions.v));
  lanes->is_zero = step->is_still;
}

}  // namespace clothfit
