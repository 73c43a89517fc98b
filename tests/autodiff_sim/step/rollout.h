// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole rollouts as functions of a few numbers q, and their derivatives both ways: carried along by
// the simulation, and by differences. q = 0 is the rollout as given.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "autodiff_sim/base/gradient_check.h"
#include "autodiff_sim/step/simulation.h"
#include "tests/support/scenes.h"

namespace clothfit {

// What one entry of q moves, per unit of it.
struct Direction {
  std::string name;
  double typical;      // of q
  int parameter = -1;  // moved by q
  // d inputs / dq, rows as in StepInputs::directions; none for an empty function.
  std::function<Eigen::VectorXd(double time, const StepInputs& inputs)> inputs;
  Eigen::VectorXd dx, dv;  // of the initial state; empty for none
};

struct Rollout {
  // Makes the simulation anew, so that no rollout depends on the one before.
  std::function<Simulation()> make;
  Eigen::VectorXd parameters;
  Eigen::VectorXd x, v;  // initial
  std::function<StepInputs(double time)> inputs;
  double step = 1.0 / 120.0;  // s
  int steps = 120;
  std::vector<Direction> directions;

  void AddParameter(const std::string& name);  // typical: its value, or its prior's where it is 0
  void AddParameters(const std::vector<std::string>& names);
};

// Steps so exact that differences of rollouts have little noise: 1e-12 of the mean edge, which is
// not far above roundoff.
SimulationOptions Precise(Integrator integrator);
// A scene's supple cloth on its path.
Rollout MakeRollout(const TestScene& scene, const SimulationOptions& options);
// A parameter by its full name.
void Set(const std::string& name, double value, Rollout* rollout);

// The positions (m) half way and at the end and the velocities (m/s) at the end.
struct RolloutResult {
  bool converged = false;
  Eigen::VectorXd values;
  Eigen::MatrixXd jacobian;  // d values / dq where it was asked for
  StepReport report;
  std::vector<int> halvings;  // of each step
};
RolloutResult RunRollout(const Rollout& rollout, const Eigen::VectorXd& q, bool with_jacobian);

// Checks all directions by differences. A rollout of which any step is halved otherwise than at q =
// 0 is another function; it is left out.
GradientCheckReport CheckRollout(const Rollout& rollout, const GradientCheckOptions& options);

// Expects every column to agree within options.tolerance, or, where the difference is no better,
// within the difference's own error; at most `undecided` of the latter. Prints the worst.
void ExpectDerivatives(const Rollout& rollout, const GradientCheckOptions& options,
                       int undecided = 0);

}  // namespace clothfit
