// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of a solved step.
#include <algorithm>
#include <utility>

#include "autodiff_sim/direct_solve.h"
#include "autodiff_sim/step_solver.h"

namespace clothfit {
namespace {

// An iteration of kLanes columns in iterations of one.
constexpr int kCostOfLanes = 3;
// Fewer than a fresh factor needs: it serves the next step too.
constexpr int kIterationsForNothing = 5;
constexpr int kTooManyIterations = 25, kPatience = 100;

}  // namespace

// What moves the step while its free velocities stand still: the states before, the parameters, the
// inputs and, through them, the held particles.
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
  directions.x += formula.gamma * directions.v;
  directions.a = (directions.v - formula.now * lanes.v - formula.before * lanes.previous_v) *
                 (1.0 / formula.gamma);
  return directions;
}

// -dr along these directions: gamma df - M gamma da - dM (v - v_hat).
Lanes<kLanes> StepSolver::RightHandSide(const StepProblem& problem, const Eigen::VectorXd& v,
                                        const ForceDirections& directions,
                                        const std::vector<bool>& awake) {
  const StepFormula& formula = problem.formula;
  const double density = (*problem.parameters)[kArealDensity];
  Lanes<kLanes> rhs = Lanes<kLanes>::Zero(v.size(), kLanes);
  const StepMotion motion(problem, v);
  model_->AddForceDerivatives(motion.Point(problem), directions, awake, &rhs);
  const Eigen::Matrix<double, 1, kLanes> density_lanes = directions.parameters.row(kArealDensity);
  for (Eigen::Index row = 0; row < rhs.rows(); ++row) {
    const double area = model_->topology().areas[static_cast<std::size_t>(row / 3)];
    rhs.row(row) = formula.gamma * (rhs.row(row) - density * area * directions.a.row(row)) -
                   area * (v[row] - problem.v_hat[row]) * density_lanes;
  }
  problem.constraints->ReduceResidual<kLanes>(&rhs);
  return rhs;
}

bool StepSolver::Differentiate(const StepProblem& problem, const StepInputs& inputs,
                               const Eigen::VectorXd& v, Sensitivity* sensitivity,
                               StepReport* report) {
  const StepFormula& formula = problem.formula;
  AssembleJacobian(problem, v, report);
  if (FactorIsWorn(false) && !RefreshFactor(report)) return false;
  const std::vector<bool> awake = model_->Awake(*problem.parameters, sensitivity->parameters());
  model_->UpdateMemoryOfOff(StepMotion(problem, v).Point(problem), awake, &new_memory_);
  int slowest = 0;
  for (std::size_t b = 0; b < sensitivity->lanes().size(); ++b) {
    StateLanes& lanes = sensitivity->lanes()[b];
    ForceDirections directions = DirectionsAtFixedVelocity(problem, inputs, *sensitivity, b);
    const Lanes<kLanes> rhs = RightHandSide(problem, v, directions, awake);
    const bool still = lanes.is_zero && rhs.isZero(0.0) && directions.v.isZero(0.0);
    if (!still) {
      // Extrapolated from the steps before: a first guess, whatever it is worth.
      Lanes<kLanes> dv = lanes.v;
      if (formula.before != 0.0) dv += lanes.v - lanes.previous_v;
      int iterations = 0;
      if (!SolveLanes(problem, rhs, &dv, &iterations, report)) return false;
      slowest = std::max(slowest, iterations);
      problem.constraints->ExpandDirection<kLanes>(&dv);
      directions.x += formula.gamma * dv;
      directions.v += dv;
      directions.a += dv * (1.0 / formula.gamma);
    }
    // Along what is known only now.
    model_->UpdateMemoryDerivatives(StepMotion(problem, v).Point(problem), directions, awake,
                                    &lanes.memory);
    lanes.previous_x = std::exchange(lanes.x, std::move(directions.x));
    lanes.previous_v = std::exchange(lanes.v, std::move(directions.v));
    lanes.is_zero = still;
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
  options.max_iterations = factor_is_current_ ? kPatience : kTooManyIterations;
  GmresReport linear = gmres_.Solve<kLanes>(&factor_, rhs, options, dv);
  *iterations += linear.iterations;
  excess_ += kCostOfLanes * std::max(0, linear.iterations - kIterationsForNothing);
  if (linear.converged) return true;
  if (!factor_is_current_ && RefreshFactor(report)) {
    options.max_iterations = kPatience;
    linear = gmres_.Solve<kLanes>(&factor_, rhs, options, dv);
    *iterations += linear.iterations;
    if (linear.converged) return true;
  }
  ++report->factorizations;
  return SolveDirectly<kLanes>(jacobian_, rhs, dv);
}

}  // namespace clothfit
