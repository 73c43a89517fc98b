// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Evaluation of a window.
#include "fitting/window_cost.h"

#include "fitting/simulation_cost.h"

namespace clothfit {

WindowSimulator::Outcome EvaluateWindow(WindowSimulator* simulator,
                                        const ObservationResiduals& observations,
                                        const WindowStart& start, const Eigen::VectorXd& theta,
                                        int first, int last, Eigen::VectorXd* residuals,
                                        RowMajorMatrix* jacobian, WindowStart* end) {
  const int rows = observations.Count(first, last);
  residuals->resize(rows);
  if (jacobian != nullptr) jacobian->resize(rows, theta.size());
  int row = 0;
  bool usable = true;
  const WindowSimulator::Observer observer = [&](int frame, const State& state,
                                                 const Sensitivity* sensitivity) {
    if (frame < first) return;
    usable = usable && observations.Evaluate(frame, state, sensitivity, row, residuals, jacobian);
    row += observations.Count(frame);
  };
  const bool derivatives = jacobian != nullptr || end != nullptr;
  const WindowSimulator::Outcome outcome =
      simulator->Run(start, theta, last, derivatives, observer, end);
  if (outcome != WindowSimulator::Outcome::kComplete) return outcome;
  usable = usable && residuals->allFinite() && (jacobian == nullptr || jacobian->allFinite());
  return usable ? outcome : WindowSimulator::Outcome::kDiverged;
}

ceres::CostFunction* MakeWindowCost(WindowSimulator* simulator,
                                    const ObservationResiduals* observations,
                                    const WindowStart* start, int num_free, int first, int last) {
  const auto evaluate = [=](const Eigen::VectorXd& theta, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    return EvaluateWindow(simulator, *observations, *start, theta, first, last, residuals,
                          jacobian) == WindowSimulator::Outcome::kComplete;
  };
  return new SimulationCost(observations->Count(first, last), num_free, evaluate);
}

LinearCost::LinearCost(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& offset)
    : jacobian_(jacobian), offset_(offset) {
  set_num_residuals(static_cast<int>(jacobian.rows()));
  mutable_parameter_block_sizes()->push_back(static_cast<int>(jacobian.cols()));
}

bool LinearCost::Evaluate(double const* const* parameters, double* residuals,
                          double** jacobians) const {
  const Eigen::Map<const Eigen::VectorXd> theta(parameters[0], jacobian_.cols());
  Eigen::Map<Eigen::VectorXd>(residuals, jacobian_.rows()) = jacobian_ * theta - offset_;
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    Eigen::Map<RowMajorMatrix>(jacobians[0], jacobian_.rows(), jacobian_.cols()) = jacobian_;
  }
  return true;
}

bool EvaluateResiduals(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                       const Eigen::VectorXd& theta, int last_frame, Eigen::VectorXd* residuals,
                       Eigen::MatrixXd* jacobian) {
  WindowSimulator simulator(scene, config, free, false, nullptr);
  const ObservationResiduals observations(scene, config);
  const WindowStart start = simulator.FirstStart(theta);
  const Eigen::VectorXd prior = free.PriorResiduals(theta);
  Eigen::VectorXd observed;
  RowMajorMatrix observed_jacobian;
  if (EvaluateWindow(&simulator, observations, start, theta, 0, last_frame, &observed,
                     jacobian != nullptr ? &observed_jacobian : nullptr) !=
      WindowSimulator::Outcome::kComplete) {
    return false;
  }
  residuals->resize(observed.size() + prior.size());
  *residuals << observed, prior;
  if (jacobian != nullptr) {
    jacobian->resize(residuals->size(), free.size());
    *jacobian << observed_jacobian, free.prior_jacobian();
  }
  return true;
}

}  // namespace clothfit
