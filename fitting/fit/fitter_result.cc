// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit has come to: errors, intervals, whether it converged.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/config/shared_parameters.h"
#include "fitting/fit/discretisation.h"
#include "fitting/fit/evaluation.h"
#include "fitting/fit/fitter.h"
#include "fitting/fit/rugged_cost.h"
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
  result->iterations = iterations_;
  // What follows is short and must be done even after an interruption.
  JointRollout rollout(scenes_, false, nullptr);
  if (!at_best_.IsAt(result->theta)) Linearise(result->theta, &rollout);
  const bool is_complete = at_best_.IsAt(result->theta);
  const Eigen::VectorXd& residuals = at_best_.residuals;
  const RowMajorMatrix& jacobian = at_best_.jacobian;
  result->steps = at_best_.steps;
  Uncertainty uncertainty;
  std::optional<JointPointFit> points;
  if (is_complete) {
    result->cost_after = CostOf(residuals, result->theta);
    if (tells_misfit_) points = MeasurePoints(scenes_, result->theta);
    if (points) result->misfit = points->all.misfit;
    std::optional<ModelErrors> errors;
    if (points) errors = points->all.errors;
    if (tells_misfit_ && !points) errors = MeasureOutlines(scenes_, result->theta);
    uncertainty = QuantifyUncertainty(free_, scenes_.NumObserved(), residuals, jacobian,
                                      errors.value_or(ModelErrors{}));
    // Whoever asks for a rough fit asks for no more than that.
    const double most = std::max(0.01, 10.0 * polish_tolerance_);
    const double decrease = ExpectedDecrease(residuals, jacobian);
    if (converged_ && config_.polish && decrease > most) {
      converged_ = false;
      uncertainty.statements.push_back(SayCostIsRugged(decrease, config_.window));
      Log(uncertainty.statements.back());
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
  result->simulated_frames = SimulatedFrames() + rollout.simulated_frames();
  result->differentiated_frames = DifferentiatedFrames() + rollout.differentiated_frames();
  result->simulations =
      static_cast<int>(std::ceil(result->simulated_frames / scenes_.NumFittedFrames()));
  result->status = Stopped()                            ? FitStatus::kInterrupted
                   : !std::isfinite(result->cost_after) ? FitStatus::kFailed
                   : converged_                         ? FitStatus::kConverged
                                                        : FitStatus::kNotConverged;
  if (scenes_.size() > 1) return FinishEach(uncertainty, points, result);
  const auto& [scene, config, free, observations] = scenes_[0];
  FillEstimates(0, uncertainty, result);
  result->after = EvaluateScene(scene, config, free, result->theta);
}

namespace {

// Each shared parameter once, as the first recording has it that moves it, then what each recording
// has found of its own.
std::vector<ParameterEstimate> JointEstimates(const JointScenes& scenes,
                                              const std::vector<FitResult>& of_each) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  std::vector<ParameterEstimate> shared, own;
  for (std::size_t k = 0; k < table.size(); ++k) {
    if (!IsShared(scenes[0].config, table[k].name)) continue;
    std::size_t first = 0;
    for (std::size_t i = of_each.size(); i-- > 0;)
      if (of_each[i].estimates[k].free) first = i;
    shared.push_back(of_each[first].estimates[k]);
  }
  for (std::size_t i = 0; i < of_each.size(); ++i) {
    for (std::size_t k = 0; k < of_each[i].estimates.size(); ++k) {
      ParameterEstimate estimate = of_each[i].estimates[k];
      const bool is_own = k >= table.size() || !IsShared(scenes[0].config, estimate.name);
      if (!is_own || !estimate.free) continue;
      estimate.name = scenes.named(i).name + "/" + estimate.name;
      own.push_back(std::move(estimate));
    }
  }
  shared.insert(shared.end(), own.begin(), own.end());
  return shared;
}

}  // namespace

void Fitter::FinishEach(const Uncertainty& uncertainty, const std::optional<JointPointFit>& points,
                        FitResult* result) const {
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes_[i];
    FitResult one = *result;  // with what was done for all
    one.recordings.clear();
    one.theta = free_.Of(i, result->theta);
    if (std::isfinite(result->cost_after)) {
      one.cost_after = CostOf(i, at_best_.residuals, result->theta);
      const int spare = observations.NumObserved(0, scene.last_fitted_frame) - free.size();
      one.noise_factor = std::max(
          1.0, rollout_.ResidualsOf(i, at_best_.residuals).norm() / std::sqrt(std::max(1, spare)));
    }
    one.misfit.reset();
    if (points) one.misfit = points->of_each[i].misfit;
    FillEstimates(i, uncertainty, &one);
    one.after = EvaluateScene(scene, config, free, one.theta);
    if (i < starts_.size()) {
      one.before = starts_[i].evaluation;
      one.cost_before = starts_[i].cost;
    }
    result->recordings.push_back(std::move(one));
  }
  result->estimates = JointEstimates(scenes_, result->recordings);
}

std::vector<ParameterEstimate> EstimatesAt(const FreeParameters& free,
                                           const Eigen::VectorXd& theta) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  const Eigen::VectorXd values = free.Values(theta), start_values = free.Values(free.start());
  std::vector<ParameterEstimate> estimates, others;
  for (std::size_t i = 0; i < table.size(); ++i) {
    ParameterEstimate estimate;
    estimate.name = table[i].name;
    estimate.unit = table[i].parameter.unit;
    estimate.value = estimate.lower95 = estimate.upper95 = values[static_cast<Eigen::Index>(i)];
    estimate.start = start_values[static_cast<Eigen::Index>(i)];
    estimates.push_back(estimate);
  }
  for (int i = 0; i < free.size(); ++i) {
    const FreeEntry& entry = free.entries()[static_cast<std::size_t>(i)];
    const bool physical = entry.kind == FreeEntry::Kind::kParameter;
    ParameterEstimate& estimate = physical ? estimates[entry.index] : others.emplace_back();
    estimate.name = entry.name;
    estimate.unit = entry.unit;
    estimate.free = true;
    estimate.value = free.UnitValue(i, theta[i]);
    estimate.start = free.UnitValue(i, free.start()[i]);
    estimate.lower95 = estimate.upper95 = std::numeric_limits<double>::quiet_NaN();
    const double margin = 1e-6 * (entry.upper - entry.lower);
    estimate.at_bound = std::isfinite(margin) &&
                        (theta[i] <= entry.lower + margin || theta[i] >= entry.upper - margin);
  }
  estimates.insert(estimates.end(), others.begin(), others.end());
  return estimates;
}

void Fitter::FillEstimates(std::size_t recording, const Uncertainty& uncertainty,
                           FitResult* result) const {
  const FreeParameters& free = scenes_[recording].free;
  const std::vector<int>& entries = free_.EntriesOf(recording);
  result->parameters = free.Values(result->theta);
  result->estimates = EstimatesAt(free, result->theta);
  std::size_t other = MakeParameterTable().size();
  for (int i = 0; i < free.size(); ++i) {
    const FreeEntry& entry = free.entries()[static_cast<std::size_t>(i)];
    const int known = entries[static_cast<std::size_t>(i)];
    const bool physical = entry.kind == FreeEntry::Kind::kParameter;
    ParameterEstimate& estimate = result->estimates[physical ? entry.index : other++];
    estimate.lower95 = free.UnitValue(i, result->theta[i] + uncertainty.lower95[known]);
    estimate.upper95 = free.UnitValue(i, result->theta[i] + uncertainty.upper95[known]);
    estimate.determined = uncertainty.determined[static_cast<std::size_t>(known)];
  }
}

}  // namespace clothfit
