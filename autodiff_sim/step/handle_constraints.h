// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Points of the cloth that are held: a particle, or a point inside a triangle. For each, the
// particle with the largest weight depends on the others, x_k = p / w_k - sum_j w_j / w_k x_j, and
// leaves the unknowns; the same substitution reduces residuals, matrices and derivatives.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/term/step_inputs.h"

namespace clothfit {

class HandleConstraints {
 public:
  // Throws InputError where two handles lie so close that they share a dependent particle.
  explicit HandleConstraints(const std::vector<HandleTarget>& handles);

  // The pairs of particles that the substitution couples beyond those of `pattern`.
  std::vector<std::vector<int>> ExtraCliques(const BlockPattern& pattern) const;

  // Whether both hold the same points, wherever they are held.
  bool SamePoints(const HandleConstraints& other) const;

  // Sets the held particles' velocities so that x_hat + gamma v meets the handles.
  void SetDependentVelocities(const Eigen::VectorXd& x_hat, double gamma, Eigen::VectorXd* v) const;

  // Sets the held particles' rows to zero.
  template <int kColumns>
  void ClearHeld(Lanes<kColumns>* lanes) const {
    for (const Held& held : held_) lanes->template middleRows<3>(3 * held.node).setZero();
  }

  // The dependent part of a change of the velocities of which the free part is given.
  template <int kColumns>
  void ExpandDirection(Lanes<kColumns>* direction) const {
    for (const Held& held : held_) {
      for (int k = 0; k < 3; ++k) direction->row(3 * held.node + k).setZero();
      for (const Share& share : held.others) {
        for (int k = 0; k < 3; ++k) {
          direction->row(3 * held.node + k) += share.factor * direction->row(3 * share.node + k);
        }
      }
    }
  }

  // Moves the held particles' rows to the particles they depend on, and clears them.
  template <int kColumns>
  void ReduceResidual(Lanes<kColumns>* r) const {
    for (const Held& held : held_) {
      for (int k = 0; k < 3; ++k) {
        for (const Share& share : held.others) {
          r->row(3 * share.node + k) += share.factor * r->row(3 * held.node + k);
        }
        r->row(3 * held.node + k).setZero();
      }
    }
  }

  // A block of a matrix in the column of a held particle.
  struct HeldBlock {
    int row, column;  // particles
    Eigen::Matrix3d value;
  };
  std::vector<HeldBlock> HeldColumns(const BlockSparseMatrix& a) const;

  // The same for rows and columns; the held particles' blocks become multiples of the identity.
  void ReduceMatrix(BlockSparseMatrix* a) const;

  // Derivative of the dependent velocities at fixed free velocities, in `lanes` columns from
  // first_column of inputs.directions on. Other rows are zero.
  void DependentVelocityDerivative(const StepInputs& inputs, int first_column,
                                   const Lanes<kLanes>& dx_hat, double gamma,
                                   Lanes<kLanes>* dv) const;

 private:
  struct Share {
    int node;
    double factor;
  };
  struct Held {
    int node;
    double inverse_weight;
    std::vector<Share> others;
    Eigen::Vector3d position;
    int input_row;
  };
  std::vector<Held> held_;
};

}  // namespace clothfit
