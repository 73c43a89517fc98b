// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a simulation carries from step to step, and its derivatives.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/linear/block_sparse_matrix.h"

namespace clothfit {

struct State {
  double time = 0.0;       // s
  Eigen::VectorXd x;       // 3N, m, world, particle after particle
  Eigen::VectorXd v;       // 3N, m/s
  Eigen::VectorXd memory;  // what terms with a memory remember
  // The step before, for BDF2; previous_step (s) is 0 where there is none.
  Eigen::VectorXd previous_x, previous_v;
  double previous_step = 0.0;
  // The velocity before that, and the step to it; only a step's first guess depends on it.
  Eigen::VectorXd older_v;
  double older_step = 0.0;
};

// Derivatives of a state along up to kLanes directions.
struct StateLanes {
  Lanes<kLanes> x, v, memory, previous_x, previous_v;
  // Exactly zero so far: nothing has moved along any of the directions.
  bool is_zero = true;
};

// Derivatives of a state along any number of directions. A direction may move the parameters, the
// inputs of any step (StepInputs::directions) and the initial state.
class Sensitivity {
 public:
  Sensitivity() = default;
  // parameter_directions: all parameters x directions, d parameter / d direction.
  Sensitivity(const State& state, const Eigen::MatrixXd& parameter_directions);

  int num_directions() const { return static_cast<int>(parameters_.cols()); }
  const Eigen::MatrixXd& parameters() const { return parameters_; }
  // Changes how the directions move the parameters from here on; as many directions as before.
  void SetParameters(const Eigen::MatrixXd& parameter_directions) {
    parameters_ = parameter_directions;
  }
  // How much of them has moved anything so far: what a step's derivatives cost goes with it.
  double ActiveShare() const;
  std::vector<StateLanes>& lanes() { return lanes_; }
  const std::vector<StateLanes>& lanes() const { return lanes_; }

  // d x / d direction and d v / d direction, 3N x directions.
  Eigen::MatrixXd x() const;
  Eigen::MatrixXd v() const;
  // Moves a state along the directions by these amounts, to first order.
  void Move(const Eigen::VectorXd& amounts, State* state) const;
  // Sets the initial state's derivatives, 3N x directions.
  void SetInitial(const Eigen::MatrixXd& dx, const Eigen::MatrixXd& dv);

 private:
  Eigen::MatrixXd parameters_;
  std::vector<StateLanes> lanes_;
};

}  // namespace clothfit
