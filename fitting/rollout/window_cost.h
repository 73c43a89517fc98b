// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The simulation of a window as one Ceres cost function of the free vector.
#pragma once

#include <ceres/cost_function.h>

#include "fitting/residuals/observation_residuals.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {

// How the residuals of a window are given.
enum class WindowRows {
  kAll,
  // As many as there are free entries and one more, whatever the number of observations: with the
  // same sum of squares, and with a Jacobian J for which J'J and J'r are the same. Without
  // derivatives the first is the root of the sum and the others are 0.
  kCompressed,
};

// Residuals of the fitted observations of frames first..last when the window is simulated from its
// start at theta, their Jacobian and the state at the end where those are asked for. Markers'
// places on the cloth are eliminated where they are known to a sigma only
// (fitting/residuals/marker_places.h).
WindowSimulator::Outcome EvaluateWindow(WindowSimulator* simulator,
                                        const ObservationResiduals& observations,
                                        const WindowStart& start, const Eigen::VectorXd& theta,
                                        int first, int last, WindowRows rows,
                                        Eigen::VectorXd* residuals, RowMajorMatrix* jacobian,
                                        WindowStart* end = nullptr);

// information * (theta - mean): what earlier windows, or the prior, know.
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(const Eigen::MatrixXd& jacobian,
             const Eigen::VectorXd& offset);  // jacobian theta - offset
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  RowMajorMatrix jacobian_;
  Eigen::VectorXd offset_;
};

// All residuals (observations of frames 0..last_frame, open loop, then priors) at theta and, where
// asked for, their Jacobian (residuals x free). False where the simulation diverges, is stopped, or
// a tracked point falls behind its camera.
bool EvaluateResiduals(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                       const Eigen::VectorXd& theta, int last_frame, Eigen::VectorXd* residuals,
                       Eigen::MatrixXd* jacobian);

}  // namespace clothfit
