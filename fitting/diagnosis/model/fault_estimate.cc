// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/fault_estimate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

constexpr int kRounds = 2;

// Amounts that are left, in the faults' units, and their sigmas.
struct Left {
  Eigen::VectorXd amounts, sigmas;
};

// Least squares of residuals + jacobian d + faults a, with the priors of the entries and of what
// was found and is left of the faults together.
std::optional<Left> EstimateLeft(const FittedScene& fitted, const std::vector<Fault>& faults,
                                 const Eigen::VectorXd& found) {
  const ObservationResiduals observations(fitted.scene, fitted.config);
  const RowFrames frames(fitted.scene, observations, kMostRows);
  const std::optional<Rows> rows = EvaluateRows(fitted, BaselinePass(fitted), frames, faults);
  if (!rows) return {};
  const Eigen::Index own = rows->jacobian.cols(), size = own + rows->faults.cols();
  Eigen::MatrixXd columns(rows->jacobian.rows(), size);
  columns << rows->jacobian, rows->faults;
  Eigen::MatrixXd information = columns.transpose() * columns;
  AddPriors(rows->entries, &information);
  Eigen::VectorXd rhs = -columns.transpose() * rows->residuals;
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    const double sigma = LargestSigma(faults[static_cast<std::size_t>(i)]);
    information(own + i, own + i) += 1.0 / (sigma * sigma);
    rhs[own + i] -= found[i] / (sigma * sigma);
  }
  const auto factor = TrySemidefinite(information);
  if (!factor || !factor->isPositive()) return {};
  const Eigen::VectorXd step = factor->solve(rhs);
  const Eigen::MatrixXd covariance = factor->solve(Eigen::MatrixXd::Identity(size, size));
  const double scale =
      std::max(1.0, rows->residuals.squaredNorm() / std::max<double>(1.0, frames.num_rows()));
  const Eigen::Index count = rows->faults.cols();
  if (!step.allFinite()) return {};
  return Left{step.tail(count), (scale * covariance.diagonal().tail(count)).cwiseSqrt()};
}

}  // namespace

void EstimateFaultAgain(const std::vector<Fault>& faults, const FitRunner& runner,
                        FittedModel* model) {
  RankedCandidate& candidate = model->candidate;
  std::vector<Fault> own;
  for (const int fault : candidate.faults) own.push_back(faults[static_cast<std::size_t>(fault)]);
  for (int k = 0; !own.empty() && k < kRounds && !runner.IsStopped(); ++k) {
    const std::optional<Left> left = EstimateLeft(model->scene, own, candidate.amounts);
    if (!left) return;
    ModelStart start = GoOn(model->scene);
    start.recording = WithoutFaults(start.recording, own, left->amounts);
    std::optional<FittedScene> again = FitModel(model->scene, start, kModelIterations, runner);
    if (!again || !(again->fit.cost_after < model->scene.fit.cost_after)) return;
    model->scene = std::move(*again);
    candidate.amounts += left->amounts;
    candidate.sigma = left->sigmas;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto index = static_cast<Eigen::Index>(i);
      SetInterval(candidate.amounts[index], candidate.sigma[index],
                  &candidate.summary.parameters[i]);
    }
  }
}

}  // namespace clothfit
