// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/levenberg_marquardt.h"

#include <ceres/manifold.h>
#include <ceres/problem.h>

namespace clothfit {
namespace {

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

// Steps end at the bounds. Bounds that Ceres knows of make it search along each step instead, with
// derivatives at every trial.
class Box : public ceres::Manifold {
 public:
  explicit Box(const Bounds& bounds) : bounds_(bounds) {}
  int AmbientSize() const override { return static_cast<int>(bounds_.lower.size()); }
  int TangentSize() const override { return AmbientSize(); }
  bool Plus(const double* x, const double* delta, double* sum) const override {
    const Eigen::Index n = bounds_.lower.size();
    Vector(sum, n) =
        (ConstVector(x, n) + ConstVector(delta, n)).cwiseMax(bounds_.lower).cwiseMin(bounds_.upper);
    return true;
  }
  bool PlusJacobian(const double* /*x*/, double* jacobian) const override {
    return Identity(jacobian);
  }
  bool Minus(const double* y, const double* x, double* difference) const override {
    const Eigen::Index n = bounds_.lower.size();
    Vector(difference, n) = ConstVector(y, n) - ConstVector(x, n);
    return true;
  }
  bool MinusJacobian(const double* /*x*/, double* jacobian) const override {
    return Identity(jacobian);
  }

 private:
  bool Identity(double* jacobian) const {
    Eigen::Map<RowMajorMatrix>(jacobian, AmbientSize(), AmbientSize()).setIdentity();
    return true;
  }
  Bounds bounds_;
};

}  // namespace

ceres::Solver::Options LevenbergMarquardtOptions(int max_iterations, double function_tolerance,
                                                 double first_radius) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = function_tolerance;
  options.parameter_tolerance = 1e-7;
  options.initial_trust_region_radius = first_radius;
  options.max_num_consecutive_invalid_steps = 20;  // a trial whose simulation diverges
  options.logging_type = ceres::SILENT;
  return options;
}

bool EndOfDescent::IsReached(const ceres::IterationSummary& iteration) {
  if (iteration.iteration == 0 || !iteration.step_is_successful) return false;
  const bool is_small = iteration.cost_change <= tolerance_ * iteration.cost;
  small_steps_ = is_small ? small_steps_ + 1 : 0;
  const bool is_free = iteration.trust_region_radius >= least_radius_;
  return small_steps_ >= (is_free ? 1 : in_turn_);
}

ceres::Solver::Summary MinimiseWithin(const Bounds& bounds, int num_residuals,
                                      const SimulationCost::Evaluator& evaluate,
                                      const ceres::Solver::Options& options,
                                      Eigen::VectorXd* unknowns) {
  const auto pinned = [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                          RowMajorMatrix* jacobian) {
    if (!evaluate(at, residuals, jacobian)) return false;
    if (jacobian == nullptr) return true;
    const Eigen::VectorXd gradient = jacobian->transpose() * *residuals;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const bool leaves = (at[i] <= bounds.lower[i] && gradient[i] > 0.0) ||
                          (at[i] >= bounds.upper[i] && gradient[i] < 0.0);
      if (leaves) jacobian->col(i).setZero();
    }
    for (const int i : bounds.held) jacobian->col(i).setZero();
    return true;
  };
  ceres::Problem problem;
  const int count = static_cast<int>(unknowns->size());
  problem.AddResidualBlock(new SimulationCost(num_residuals, count, pinned), nullptr,
                           unknowns->data());
  problem.SetManifold(unknowns->data(), new Box(bounds));
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary;
}

}  // namespace clothfit
