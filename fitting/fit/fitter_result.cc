// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit has come to: errors, intervals, whether it converged.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fitting/fit/discretisation.h"
#include "fitting/fit/evaluation.h"
#include "fitting/fit/fitter.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {

Eigen::MatrixXd Fitter::Information(const RowMajorMatrix& jacobian) const {
  const Eigen::MatrixXd& prior = free_.prior_jacobian();
  return jacobian.transpose() * jacobian + prior.transpose() * prior;
}

double Fitter::ExpectedDecrease(const Eigen::VectorXd& residuals,
                                const RowMajorMatrix& jacobian) const {
  const Eigen::VectorXd prior = free_.PriorResiduals(progress_.theta);
  const Eigen::VectorXd gradient =
      jacobian.transpose() * residuals + free_.prior_jacobian().transpose() * prior;
  const Eigen::MatrixXd information = Information(jacobian);
  std::vector<int> inner;  // entries that may follow their gradient
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    const bool held = gradient[i] > 0.0 ? progress_.theta[i] <= entry.lower + 1e-9
                                        : progress_.theta[i] >= entry.upper - 1e-9;
    if (!held) inner.push_back(i);
  }
  if (inner.empty()) return 0.0;
  const Eigen::VectorXd g = gradient(inner);
  const Eigen::MatrixXd h = information(inner, inner);
  const double cost = 0.5 * (residuals.squaredNorm() + prior.squaredNorm());
  const auto factor = TrySemidefinite(h);
  if (!factor) return std::numeric_limits<double>::infinity();  // nothing is known of it
  return 0.5 * g.dot(factor->solve(g)) / std::max(cost, 1e-300);
}

void Fitter::Finish(FitResult* result) {
  result->theta = progress_.theta;
  result->parameters = free_.Values(result->theta);
  result->iterations = iterations_;
  // What follows is short and must be done even after an interruption.
  WindowSimulator simulator(scene_, config_, free_, false, nullptr);
  if (!at_best_.IsAt(result->theta)) Linearise(result->theta, &simulator);
  const bool is_complete = at_best_.IsAt(result->theta);
  const Eigen::VectorXd& residuals = at_best_.residuals;
  const RowMajorMatrix& jacobian = at_best_.jacobian;
  result->steps = at_best_.steps;
  Uncertainty uncertainty;
  if (is_complete) {
    result->cost_after =
        0.5 * (residuals.squaredNorm() + free_.PriorResiduals(result->theta).squaredNorm());
    const std::optional<PointFit> points =
        tells_misfit_ ? MeasurePoints(scene_, config_, free_, result->theta) : std::nullopt;
    if (points) result->misfit = points->misfit;
    uncertainty = QuantifyUncertainty(free_, observations_.NumObserved(0, scene_.last_fitted_frame),
                                      residuals, jacobian, points ? points->errors : ModelErrors{});
    // Whoever asks for a rough fit asks for no more than that.
    const double most = std::max(0.01, 10.0 * polish_tolerance_);
    const double decrease = ExpectedDecrease(residuals, jacobian);
    if (converged_ && config_.polish && decrease > most) {
      converged_ = false;
      Log(
          fmt::format("Levenberg-Marquardt came to rest where a full step promises {:.0f} % less "
                      "cost: the cost is rugged here; shorter windows may get past it",
                      100.0 * decrease));
    }
  } else {
    result->cost_after = std::numeric_limits<double>::infinity();
    uncertainty.sigma = uncertainty.lower95 = uncertainty.upper95 =
        Eigen::VectorXd::Constant(free_.size(), std::numeric_limits<double>::quiet_NaN());
    uncertainty.determined.assign(static_cast<std::size_t>(free_.size()), false);
    uncertainty.statements.push_back(
        "the open-loop simulation of all fitted frames diverges at the result");
  }
  if (is_complete && HasWork() && jacobian.isZero(0.0)) {
    converged_ = false;
    uncertainty.statements.push_back("nothing that is free moves what was observed");
  }
  result->noise_factor = uncertainty.noise_factor;
  result->statements = uncertainty.statements;
  FillEstimates(uncertainty, result);
  result->after = EvaluateScene(scene_, config_, free_, result->theta);
  result->simulated_frames = SimulatedFrames() + simulator.simulated_frames();
  result->differentiated_frames = DifferentiatedFrames() + simulator.differentiated_frames();
  result->simulations =
      static_cast<int>(std::ceil(result->simulated_frames / std::max(1, scene_.last_fitted_frame)));
  result->status = Stopped()                            ? FitStatus::kInterrupted
                   : !std::isfinite(result->cost_after) ? FitStatus::kFailed
                   : converged_                         ? FitStatus::kConverged
                                                        : FitStatus::kNotConverged;
}

void Fitter::FillEstimates(const Uncertainty& uncertainty, FitResult* result) const {
  const std::vector<NamedParameter> table = MakeParameterTable();
  const Eigen::VectorXd start_values = free_.Values(free_.start());
  std::vector<ParameterEstimate> others;
  for (std::size_t i = 0; i < table.size(); ++i) {
    ParameterEstimate estimate;
    estimate.name = table[i].name;
    estimate.unit = table[i].parameter.unit;
    estimate.value = estimate.lower95 = estimate.upper95 =
        result->parameters[static_cast<Eigen::Index>(i)];
    estimate.start = start_values[static_cast<Eigen::Index>(i)];
    result->estimates.push_back(estimate);
  }
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    const bool physical = entry.kind == FreeEntry::Kind::kParameter;
    ParameterEstimate& estimate = physical ? result->estimates[entry.index] : others.emplace_back();
    const double theta = result->theta[i];
    estimate.name = entry.name;
    estimate.unit = entry.unit;
    estimate.free = true;
    estimate.value = free_.UnitValue(i, theta);
    estimate.start = free_.UnitValue(i, free_.start()[i]);
    estimate.lower95 = free_.UnitValue(i, theta + uncertainty.lower95[i]);
    estimate.upper95 = free_.UnitValue(i, theta + uncertainty.upper95[i]);
    estimate.determined = uncertainty.determined[i];
    const double margin = 1e-6 * (entry.upper - entry.lower);
    estimate.at_bound =
        std::isfinite(margin) && (theta <= entry.lower + margin || theta >= entry.upper - margin);
  }
  result->estimates.insert(result->estimates.end(), others.begin(), others.end());
}

}  // namespace clothfit
