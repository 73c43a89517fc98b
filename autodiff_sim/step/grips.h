// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the terms `grip` and `grip_slip` do where grips are rigid, and constraints hold the cloth
// instead of forces; and the forces where they are not.
#pragma once

#include <Eigen/Core>

#include "autodiff_sim/step/cloth_model.h"
#include "autodiff_sim/term/step_inputs.h"

namespace clothfit {

class Grips {
 public:
  // Grips are rigid and hold tight in a model that lacks these terms.
  explicit Grips(const ClothModel& model);

  bool AreRigid(const Eigen::VectorXd& parameters) const;

  // Moves the places that hold the cloth by how far it has slipped at `time` (s). Where
  // `parameter_directions` (all parameters x directions) are given, the inputs' directions get the
  // derivatives by the slip's own parameters.
  void ApplySlip(const ClothModel& model, const Eigen::VectorXd& parameters, double time,
                 const Eigen::MatrixXd* parameter_directions, StepInputs* inputs) const;

  // The derivatives of the places by a compliance that is switched on, where rigid handles exert
  // `handle_forces` (N, 3N): each gives way to the cloth's pull. The forces' own change counts for
  // nothing while the compliance is 0.
  void Yield(const Eigen::VectorXd& handle_forces, const Eigen::MatrixXd& parameter_directions,
             StepInputs* inputs) const;

  // The forces (N, 3N) on the cloth at x (3N, m) of grips that are not rigid.
  Eigen::VectorXd Forces(const ClothModel& model, const Eigen::VectorXd& parameters, double time,
                         const StepInputs& inputs, const Eigen::VectorXd& x) const;

 private:
  int compliance_, slip_;  // indices of the parameters of both terms, the slip's first; -1 for none
};

}  // namespace clothfit
