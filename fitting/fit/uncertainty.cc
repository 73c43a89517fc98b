// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Covariance, and undetermined directions in words.
#include "fitting/fit/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <ceres/covariance.h>
#include <ceres/problem.h>
#include <fmt/format.h>

#include "fitting/fit/profile_interval.h"
#include "fitting/rollout/window_cost.h"

namespace clothfit {
namespace {

// Ceres' covariance of the problem with constant Jacobians `data` and `prior`.
Eigen::MatrixXd Covariance(const Eigen::MatrixXd& data, const Eigen::MatrixXd& prior) {
  const int n = static_cast<int>(prior.cols());
  std::vector<double> theta(static_cast<std::size_t>(n), 0.0);
  ceres::Problem problem;
  if (data.rows() > 0) {
    problem.AddResidualBlock(new LinearCost(data, Eigen::VectorXd::Zero(data.rows())), nullptr,
                             theta.data());
  }
  problem.AddResidualBlock(new LinearCost(prior, Eigen::VectorXd::Zero(prior.rows())), nullptr,
                           theta.data());
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::DENSE_SVD;
  options.null_space_rank =
      -1;  // what nothing determines gets no variance rather than an infinite one
  ceres::Covariance covariance(options);
  RowMajorMatrix result = RowMajorMatrix::Zero(n, n);
  const std::vector<std::pair<const double*, const double*>> blocks = {
      {theta.data(), theta.data()}};
  if (!covariance.Compute(blocks, &problem)) return Eigen::MatrixXd::Constant(n, n, NAN);
  covariance.GetCovarianceBlock(theta.data(), theta.data(), result.data());
  return result;
}

// A sparse basis of the rows' span, by elimination with full pivoting: directions that can be said.
Eigen::MatrixXd SparseBasis(Eigen::MatrixXd rows) {
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    Eigen::Index i = 0, j = 0;
    rows.bottomRows(rows.rows() - r).cwiseAbs().maxCoeff(&i, &j);
    rows.row(r).swap(rows.row(r + i));
    rows.row(r) /= rows(r, j);
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      if (k != r) rows.row(k) -= rows(k, j) * rows.row(r);
    }
  }
  return rows;
}

// One undetermined direction in words. `direction` is in the free vector's scale, `share` in the
// priors'.
std::string Describe(const std::vector<FreeEntry>& entries, const Eigen::VectorXd& direction,
                     const Eigen::VectorXd& share) {
  constexpr double kNegligible = 0.05;
  std::vector<int> parts;
  for (int i = 0; i < direction.size(); ++i) {
    if (std::abs(share[i]) > kNegligible * share.cwiseAbs().maxCoeff()) parts.push_back(i);
  }
  if (parts.size() == 1) {
    return fmt::format("{} is not determined by the recording; it stays at its prior",
                       entries[parts[0]].name);
  }
  double largest = 0.0;
  for (const int i : parts) largest = std::max(largest, std::abs(direction[i]));
  bool all_log = true, all_alike = true;
  for (const int i : parts) {
    all_log = all_log && entries[i].is_log;
    all_alike = all_alike && std::abs(direction[i] / direction[parts[0]] - 1.0) < 0.2;
  }
  std::string names;
  if (all_log && all_alike) {
    for (const int i : parts) names += (names.empty() ? "" : ", ") + entries[i].name;
    return fmt::format(
        "only the ratios of {} are determined by the recording: all of them times one factor give "
        "the same motion; that factor is held at the priors",
        names);
  }
  for (const int i : parts) {
    names += fmt::format("{}{:+.2f} {}{}", names.empty() ? "" : " ", direction[i] / largest,
                         entries[i].is_log ? "log " : "", entries[i].name);
  }
  return fmt::format(
      "the combination {} is not determined by the recording; it is held at the priors", names);
}

// The data's information on the free vector: matrix and gradient at the size that residuals really
// have.
struct DataKnow {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

// Information about entries whose estimates have the sandwich covariance
// I^-1 (variance I + lasting) I^-1, I = J'J (Newey and West 1987): I (variance I + lasting)^-1 I.
DataKnow OfData(const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian, double variance,
                const ModelErrors& errors) {
  const Eigen::MatrixXd own = jacobian.transpose() * jacobian;
  const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
  DataKnow data{own / variance, gradient / variance};
  if (errors.lasting.size() > 0) {
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> of_gradient(variance * own +
                                                                              errors.lasting);
    data.information = own * of_gradient.solve(own);
    data.gradient = own * of_gradient.solve(gradient);
  }
  return data;
}

// Rows with J'J = information, which is positive semidefinite but for rounding.
Eigen::MatrixXd RowsOf(const Eigen::MatrixXd& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
  return eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

// Fills in sigmas and the ends of the 95 % intervals. `covariance` and `data` know nothing of the
// discretisation error, whose amount is independent of them; by `shift` all entries move together.
void FillIntervals(const FreeVector& free, const DataKnow& data, const Eigen::MatrixXd& covariance,
                   const ModelErrors& errors, Uncertainty* result) {
  constexpr double kTwoSided95 = 1.959964;
  const Eigen::VectorXd of_data = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(of_data.size());
  if (errors.shift.size() > 0) shift = errors.shift;
  const Eigen::VectorXd of_mesh = errors.amplitude * shift;
  result->sigma = (of_data.array().square() + of_mesh.array().square()).sqrt();
  result->upper95 = kTwoSided95 * of_data;
  result->lower95 = -result->upper95;
  if (!covariance.allFinite()) return;
  ResponseModel model;
  model.data_information = data.information;
  model.data_gradient = data.gradient;
  model.prior_information = free.prior_jacobian().transpose() * free.prior_jacobian();
  for (const FreeEntry& entry : free.entries()) model.is_log.push_back(entry.is_log);
  for (int i = 0; i < free.size(); ++i) {
    if (free.entries()[i].kind != FreeEntry::Kind::kParameter) continue;
    const Interval interval = ProfileInterval(model, covariance, i, kTwoSided95);
    result->lower95[i] = interval.lower;
    result->upper95[i] = interval.upper;
  }
  for (int i = 0; i < free.size(); ++i) {
    const double expected = errors.mean * shift[i], half = kTwoSided95 * of_mesh[i];
    result->lower95[i] = expected - std::hypot(result->lower95[i], half);
    result->upper95[i] = expected + std::hypot(result->upper95[i], half);
  }
}

}  // namespace

Uncertainty QuantifyUncertainty(const FreeVector& free, int num_observed,
                                const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian,
                                const ModelErrors& errors) {
  Uncertainty result;
  const int n = free.size();
  const double spare = std::max(1, num_observed - n);
  result.noise_factor = std::max(1.0, std::sqrt(residuals.squaredNorm() / spare));
  if (n == 0) return result;
  const double variance = result.noise_factor * result.noise_factor * errors.correlation;
  const DataKnow data = OfData(residuals, jacobian, variance, errors);
  Eigen::MatrixXd covariance = Covariance(RowsOf(data.information), free.prior_jacobian());
  FillIntervals(free, data, covariance, errors, &result);
  if (errors.shift.size() > 0)
    covariance += errors.amplitude * errors.amplitude * errors.shift * errors.shift.transpose();
  std::vector<int> physical;
  for (int i = 0; i < n; ++i) {
    const FreeEntry& entry = free.entries()[i];
    constexpr double kLearned = 0.5;  // of the prior's variance
    result.determined.push_back(result.sigma[i] * result.sigma[i] <
                                kLearned * entry.prior_sigma * entry.prior_sigma);
    if (entry.kind == FreeEntry::Kind::kParameter) physical.push_back(i);
  }
  std::vector<FreeEntry> entries;
  for (const int i : physical) entries.push_back(free.entries()[i]);
  result.statements = DescribeUndetermined(entries, covariance(physical, physical));
  return result;
}

std::vector<std::string> DescribeUndetermined(const std::vector<FreeEntry>& entries,
                                              const Eigen::MatrixXd& covariance) {
  std::vector<std::string> statements;
  if (entries.empty()) return statements;
  const auto count = static_cast<Eigen::Index>(entries.size());
  Eigen::VectorXd sigma(count);
  for (Eigen::Index i = 0; i < count; ++i)
    sigma[i] = entries[static_cast<std::size_t>(i)].prior_sigma;
  // In units of the priors the covariance has the eigenvalues 1 / (1 + s^2), s the singular values
  // of the Jacobian with all other entries projected out.
  const Eigen::VectorXd inverse = sigma.cwiseInverse();
  const Eigen::MatrixXd shrinkage = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(shrinkage);
  const int open = static_cast<int>((eigen.eigenvalues().array() > 0.5).count());  // s < 1
  const Eigen::MatrixXd basis = SparseBasis(eigen.eigenvectors().rightCols(open).transpose());
  for (int k = 0; k < open; ++k) {
    const Eigen::VectorXd share = basis.row(k).transpose();
    statements.push_back(Describe(entries, share.cwiseProduct(sigma), share));
  }
  return statements;
}

}  // namespace clothfit
