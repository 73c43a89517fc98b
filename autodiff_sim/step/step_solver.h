// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Solves one implicit step and differentiates it. Inside the simulation; nothing else includes it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "autodiff_sim/linear/gmres.h"
#include "autodiff_sim/linear/sparse_cholesky.h"
#include "autodiff_sim/linear/sparse_lu.h"
#include "autodiff_sim/step/cloth_model.h"
#include "autodiff_sim/step/simulation.h"

namespace clothfit {

// One step's known quantities: everything that the residual depends on but the velocity.
struct StepProblem {
  double end_time = 0.0;
  double step = 0.0;  // s
  StepFormula formula;
  Eigen::VectorXd start;  // m, the positions when the step began
  Eigen::VectorXd x_hat, v_hat, memory;
  bool keep_clear = false;  // of what there is to collide with, from the start on
  const Eigen::VectorXd* parameters = nullptr;
  const HandleConstraints* constraints = nullptr;
};

// The motion at the end of a step that a velocity stands for.
struct StepMotion {
  StepMotion(const StepProblem& problem, const Eigen::VectorXd& velocity)
      : x(problem.x_hat + problem.formula.gamma * velocity),
        v(velocity),
        a((velocity - problem.v_hat) / problem.formula.gamma) {}
  ForcePoint Point(const StepProblem& problem) const {
    return {problem.end_time,    problem.step,  x, v, a, problem.start,
            *problem.parameters, problem.memory};
  }
  Eigen::VectorXd x;
  const Eigen::VectorXd& v;
  Eigen::VectorXd a;
};

class StepSolver {
 public:
  StepSolver(ClothModel* model, const SimulationOptions& options);

  // Newton's method from v on, with an exact Jacobian, GMRES preconditioned by a kept factor, and a
  // line search on the preconditioned residual (the natural level function of Deuflhard 2004,
  // sec. 3.3). Returns whether it converged.
  bool Solve(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report);

  // As after Solve where it has come to v, without contact.
  void Take(const StepProblem& problem, const Eigen::VectorXd& v);

  // Derivatives at the solved v, by the implicit function theorem: A dv = -dr at fixed v, with the
  // exact Jacobian A of the residual. Advances every lane. Returns false where a linear solve
  // fails.
  bool Differentiate(const StepProblem& problem, const StepInputs& inputs, const Eigen::VectorXd& v,
                     Sensitivity* sensitivity, StepReport* report);

  // The residual (N s) at the last velocity tried, before and after the handles took up their part.
  const Eigen::VectorXd& full_residual() const { return full_residual_; }
  const Eigen::VectorXd& reduced_residual() const { return reduced_residual_; }
  const Eigen::VectorXd& memory() const { return new_memory_; }
  void Reset();
  // Forgets the contacts too, so that what follows depends on nothing before.
  void ResetAll();

 private:
  // Contact. The first iterate: as far from the start towards the guess v as nothing meets, with
  // the handles in their places. Returns false where the handles' own motion meets something.
  bool StartClear(const StepProblem& problem, Eigen::VectorXd* v, StepReport* report);
  // The largest share of d that the cloth may move from v without meeting itself.
  double ClearShare(const StepProblem& problem, const Eigen::VectorXd& v, const Eigen::VectorXd& d,
                    StepReport* report);
  // Lets the elements be the contacts at the motion's end, and makes room for them in the matrices.
  void PrepareContacts(const StepProblem& problem, const StepMotion& motion, StepReport* report);
  void MakeMatrices(Ordering ordering);
  // Residual at v, full and reduced, and the memory there.
  const Eigen::VectorXd& Residual(const StepProblem& problem, const Eigen::VectorXd& v);
  void AssembleJacobian(const StepProblem& problem, const Eigen::VectorXd& v, StepReport* report);
  bool RefreshFactor(StepReport* report);
  // Whether the factor's age has cost about as many linear iterations as another factor does; if
  // careful, whether it has any.
  bool FactorIsWorn(bool careful) const;
  void UpdateMemoryOfOff(const StepProblem& problem, const Eigen::VectorXd& v);
  // Sets `estimate_`, P^-1 of the reduced residual: an estimate of the error of the velocities.
  // m/s, its norm and its largest component.
  struct Error {
    double norm, largest;
  };
  Error EstimateError();
  // The Newton direction; refreshes the factor when GMRES takes too long with it.
  bool Direction(double relative_tolerance, Eigen::VectorXd* d, StepReport* report);
  // Moves v along d as far as the level function falls. Returns the step's share of d, 0 for none;
  // `error` becomes that at the new v.
  double LineSearch(const StepProblem& problem, const Eigen::VectorXd& d, double largest_share,
                    Eigen::VectorXd* v, Error* error);
  // What moves the step: x and a by the states before alone, v of the held particles alone.
  ForceDirections DirectionsAtFixedVelocity(const StepProblem& problem, const StepInputs& inputs,
                                            const Sensitivity& sensitivity,
                                            std::size_t block) const;
  Lanes<kLanes> RightHandSide(const StepProblem& problem, const Eigen::VectorXd& v,
                              const ForceDirections& directions,
                              const std::vector<bool>& awake) const;
  // What becomes of one block of directions in a step.
  struct LanesStep {
    ForceDirections directions;
    Lanes<kLanes> rhs, dv;
    bool is_idle = false;   // nothing moves, nothing has moved
    bool is_still = false;  // nothing but memory moves
    bool is_solved = false;
    int iterations = 0;
  };
  // Sets up the block's system and tries to solve it with the factor as it is. Blocks do not depend
  // on one another.
  LanesStep BeginLanes(const StepProblem& problem, const StepInputs& inputs,
                       const Eigen::VectorXd& v, const std::vector<bool>& awake,
                       const Sensitivity& sensitivity, std::size_t block) const;
  // Solves it with a fresh factor or directly, where the try was in vain.
  bool SolveStubbornLanes(LanesStep* step, StepReport* report);
  void FinishLanes(const StepProblem& problem, const Eigen::VectorXd& v,
                   const std::vector<bool>& awake, LanesStep* step, StateLanes* lanes) const;
  GmresReport SolveLanes(LanesStep* step) const;
  // Whether what the derivatives are solved with is a factor of jacobian_ itself.
  bool SolvesWithFactorOfNow() const { return use_whole_ || factor_is_current_; }
  // Factors the Jacobian whole. False where that takes pivots.
  bool FactorWhole(StepReport* report);
  ClothModel* model_;
  SimulationOptions options_;
  double position_tolerance_;  // m
  BlockSparseMatrix jacobian_;
  // Of jacobian_ before it was reduced.
  std::vector<HandleConstraints::HeldBlock> held_columns_;
  std::optional<BlockSparseMatrix> stiffness_;  // df/dx of the last step with derivatives
  // What is factored in its place where the cloth is in contact with itself; see
  // ClothModel::AddContactStiffness.
  BlockSparseMatrix definite_;
  bool use_definite_ = false;
  SparseCholesky factor_;
  Gmres gmres_;
  bool factor_is_current_ = false;  // of jacobian_
  std::optional<SparseLu> whole_;   // of the last step with derivatives
  // What the derivatives of this step are solved with, where it is that; else factor_.
  bool use_whole_ = false;
  // Linear iterations since the last factorisation beyond those that a fresh factor needs.
  int excess_ = 0;
  Preconditioned<1> estimate_;
  int estimated_with_ = 0;  // number of the factorisation
  Eigen::VectorXd full_residual_, reduced_residual_, force_, new_memory_;
};

}  // namespace clothfit
