// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/null_residuals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <Eigen/Eigenvalues>

namespace clothfit {
namespace {

// How much finer: the error that a fit's mesh makes is mostly gone, and the cost bearable.
constexpr double kFinerMesh = 1.6;
constexpr double kFinerStep = 0.5;

// Moves a fit's parameters and unknowns along a random direction of their posterior.
FittedScene DrawAround(const FittedScene& fitted, const Rows& baseline, const Eigen::MatrixXd& root,
                       std::mt19937_64* random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd unit(root.cols());
  for (double& u : unit) u = normal(*random);
  const Eigen::VectorXd moved = root * unit;
  FittedScene drawn = fitted;
  const auto fabric = moved.size() - fitted.unknown.size();
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    const FreeEntry& entry = baseline.entries[static_cast<std::size_t>(i)];
    if (i >= fabric) {
      drawn.unknown[i - fabric] += moved[i];
      continue;
    }
    ParameterSetting& setting = drawn.values.parameters.at(entry.name);
    const double value = entry.is_log ? setting.value * std::exp(std::clamp(moved[i], -0.5, 0.5))
                                      : setting.value + moved[i];
    setting.value = std::clamp(value, setting.lower, setting.upper);
  }
  return drawn;
}

}  // namespace

FittedScene Finer(const FittedScene& fitted, bool mesh, bool step) {
  std::array<int, 2> resolution = fitted.scene.mesh.grid;
  if (mesh && fitted.scene.mesh.is_grid()) {
    for (int& n : resolution) n = 1 + static_cast<int>(std::lround(kFinerMesh * (n - 1)));
  } else {
    resolution = fitted.config.resolution;
  }
  return WithOtherSteps(fitted, resolution,
                        step ? kFinerStep * fitted.scene.step : fitted.config.max_step);
}

NumericalErrors MeasureNumericalErrors(const FittedScene& fitted, const RowFrames& frames,
                                       const Rows& baseline, int draws, std::uint64_t seed) {
  NumericalErrors errors;
  const auto zero = Eigen::VectorXd::Zero(frames.num_rows());
  const auto difference = [&](const FittedScene& fine, const Eigen::VectorXd& coarse) {
    const std::optional<Eigen::VectorXd> r = ResidualsOfOtherSteps(fine, fitted, frames);
    return r ? Eigen::VectorXd(*r - coarse) : Eigen::VectorXd(zero);
  };
  errors.half_step = difference(Finer(fitted, false, true), baseline.residuals);
  errors.finer_mesh = difference(Finer(fitted, true, false), baseline.residuals);
  // Half a posterior sigma: what is drawn should still look like the recording.
  const Eigen::Index n = baseline.jacobian.cols();
  Eigen::MatrixXd information = baseline.jacobian.transpose() * baseline.jacobian;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double sigma = baseline.entries[static_cast<std::size_t>(i)].prior_sigma;
    information(i, i) += 1.0 / (sigma * sigma);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
  const Eigen::MatrixXd root =
      0.5 * eigen.eigenvectors() *
      eigen.eigenvalues().cwiseMax(1e-12).cwiseSqrt().cwiseInverse().asDiagonal();
  std::mt19937_64 random(seed);
  for (int k = 0; k < draws; ++k) {
    const FittedScene drawn = DrawAround(fitted, baseline, root, &random);
    const std::optional<Rows> coarse = EvaluateRows(drawn, {drawn.values}, frames, {});
    const std::optional<Eigen::VectorXd> fine =
        ResidualsOfOtherSteps(Finer(drawn, true, true), drawn, frames);
    if (coarse && fine) errors.at_draws.push_back(*fine - coarse->residuals);
  }
  return errors;
}

std::vector<NullResidual> DrawNulls(const Eigen::MatrixXd& gram, Eigen::Index num_rows,
                                    const std::vector<DrawnColumn>& numerical,
                                    const std::vector<DrawnColumn>& faults, int count,
                                    std::uint64_t seed) {
  // Products of unit noise with columns have the Gram matrix as their covariance.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const double least = 1e-10 * std::max(1e-300, roots.maxCoeff());
  const auto rank = static_cast<double>((roots.array() > least).count());
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<NullResidual> nulls;
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd unit(gram.cols());
    for (double& u : unit) u = normal(random);
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
      if (roots[i] <= least) unit[i] = 0.0;
    }
    const Eigen::VectorXd noise = eigen.eigenvectors() * roots.cwiseProduct(unit);
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(gram.cols());
    if (!numerical.empty()) {
      const DrawnColumn& error = numerical[static_cast<std::size_t>(random() % numerical.size())];
      amounts[error.column] += error.amount * (1.0 + 0.3 * normal(random));
    }
    for (const DrawnColumn& fault : faults) amounts[fault.column] += fault.amount * normal(random);
    const Eigen::VectorXd moved = gram * amounts;
    // The part of the noise that no column shares has a chi-squared length.
    const double others = std::max(0.0, static_cast<double>(num_rows) - rank);
    const double rest = std::max(0.0, others + std::sqrt(2.0 * others) * normal(random));
    NullResidual null;
    null.products = noise + moved;
    null.squared = unit.squaredNorm() + rest + 2.0 * amounts.dot(noise) + amounts.dot(moved);
    nulls.push_back(std::move(null));
  }
  return nulls;
}

}  // namespace clothfit
