// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The simulation of a window as one Ceres cost function of the free vector.
#pragma once

#include <ceres/cost_function.h>

#include "fitting/observation_residuals.h"
#include "fitting/window_simulator.h"

namespace clothfit {

// Residuals of the fitted observations of frames first..last when the window is simulated from its
// start at theta, their Jacobian and the state at the end where those are asked for.
WindowSimulator::Outcome EvaluateWindow(WindowSimulator* simulator,
                                        const ObservationResiduals& observations,
                                        const WindowStart& start, const Eigen::VectorXd& theta,
                                        int first, int last, Eigen::VectorXd* residuals,
                                        RowMajorMatrix* jacobian, WindowStart* end = nullptr);

// Residuals of the frames first..last, of which `first` is the start's own or the one after it.
class WindowCost : public ceres::CostFunction {
 public:
  // The arguments must outlive this object.
  WindowCost(WindowSimulator* simulator, const ObservationResiduals* observations,
             const WindowStart* start, int num_free, int first, int last);

  // False where the simulation diverges, is stopped, or a tracked point falls behind its camera.
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  WindowSimulator* simulator_;
  const ObservationResiduals* observations_;
  const WindowStart* start_;
  int first_, last_;
};

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
// asked for, their Jacobian (residuals x free). False as in WindowCost.
bool EvaluateResiduals(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                       const Eigen::VectorXd& theta, int last_frame, Eigen::VectorXd* residuals,
                       Eigen::MatrixXd* jacobian);

}  // namespace clothfit
