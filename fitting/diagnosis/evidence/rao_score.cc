// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/evidence/rao_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// Of the largest eigenvalue: below it a direction is not seen at all.
constexpr double kUnseen = 1e-10;

Eigen::MatrixXd PseudoInverse(const Eigen::MatrixXd& symmetric) {
  if (symmetric.size() == 0) return symmetric;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  const double least = kUnseen * std::max(1e-300, eigen.eigenvalues().maxCoeff());
  const Eigen::VectorXd inverse =
      (eigen.eigenvalues().array() > least)
          .select(eigen.eigenvalues().cwiseMax(least).cwiseInverse(), 0.0);
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

// Columns brought to length 1, so that units do not decide what counts as unseen.
struct Scaled {
  Eigen::MatrixXd gram;
  Eigen::VectorXd scale;
};
Scaled ToUnitLength(const Eigen::MatrixXd& gram) {
  Scaled result;
  result.scale = gram.diagonal().cwiseMax(0.0).cwiseSqrt();
  for (double& s : result.scale) s = s > 0.0 ? 1.0 / s : 0.0;
  result.gram = result.scale.asDiagonal() * gram * result.scale.asDiagonal();
  return result;
}

}  // namespace

int ColumnSet::Add(const Eigen::MatrixXd& columns) {
  const Eigen::Index first = values_.cols();
  values_.conservativeResize(Eigen::NoChange, first + columns.cols());
  values_.rightCols(columns.cols()) = columns;
  return static_cast<int>(first);
}

Projection::Projection(const Eigen::MatrixXd& gram, const std::vector<Nuisance>& nuisances) {
  const auto n = static_cast<Eigen::Index>(nuisances.size());
  for (const Nuisance& nuisance : nuisances) columns_.push_back(nuisance.column);
  cross_ = gram(Eigen::all, columns_);
  Eigen::MatrixXd information = gram(columns_, columns_);
  for (Eigen::Index i = 0; i < n; ++i)
    information(i, i) += nuisances[static_cast<std::size_t>(i)].precision;
  const Scaled scaled = ToUnitLength(information);
  inverse_ = scaled.scale.asDiagonal() * PseudoInverse(scaled.gram) * scaled.scale.asDiagonal();
  projected_ = gram - cross_ * inverse_ * cross_.transpose();
}

Eigen::VectorXd Projection::Products(const Eigen::VectorXd& products) const {
  const Eigen::VectorXd own = products(columns_);
  return products - cross_ * (inverse_ * own);
}

double Projection::Product(double product, const Eigen::VectorXd& a,
                           const Eigen::VectorXd& b) const {
  const Eigen::VectorXd own_a = a(columns_), own_b = b(columns_);
  return product - own_a.dot(inverse_ * own_b);
}

Scorer::Scorer(const Projection& projection, ScoredGroup group)
    : group_(std::move(group)),
      all_(group_.columns.size()),
      information_(projection.gram()(group_.columns, group_.columns)) {
  std::iota(all_.begin(), all_.end(), 0);
  for (std::size_t i = 0; i < group_.precision.size(); ++i)
    information_.diagonal()[static_cast<Eigen::Index>(i)] += group_.precision[i];
  inverse_ = InverseOf(all_);
}

Eigen::MatrixXd Scorer::InverseOf(const std::vector<int>& in) const {
  const Scaled scaled = ToUnitLength(information_(in, in));
  return scaled.scale.asDiagonal() * PseudoInverse(scaled.gram) * scaled.scale.asDiagonal();
}

Score Scorer::Of(const Eigen::VectorXd& projected_products) const {
  const auto n = static_cast<Eigen::Index>(group_.columns.size());
  Score score;
  score.amounts = Eigen::VectorXd::Zero(n);
  score.sigma = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  // Amounts that came out impossible are left out, the worst first.
  std::vector<int> in = all_;
  while (!in.empty()) {
    const Eigen::MatrixXd inverse = in.size() == all_.size() ? inverse_ : InverseOf(in);
    Eigen::VectorXd products(static_cast<Eigen::Index>(in.size()));
    for (std::size_t i = 0; i < in.size(); ++i)
      products[static_cast<Eigen::Index>(i)] =
          projected_products[group_.columns[static_cast<std::size_t>(in[i])]];
    const Eigen::VectorXd amounts = -(inverse * products);
    int worst = -1;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (group_.is_one_sided[static_cast<std::size_t>(in[i])] && amounts[k] < 0.0 &&
          (worst < 0 || amounts[k] < amounts[worst])) {
        worst = static_cast<int>(i);
      }
    }
    if (worst >= 0) {
      in.erase(in.begin() + worst);
      continue;
    }
    score.decrease = std::max(0.0, -amounts.dot(products));
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      score.amounts[in[i]] = amounts[k];
      if (inverse(k, k) > 0.0) score.sigma[in[i]] = std::sqrt(inverse(k, k));
    }
    break;
  }
  return score;
}

Score ScoreOf(const Projection& projection, const ScoredGroup& group,
              const Eigen::VectorXd& projected_products) {
  return Scorer(projection, group).Of(projected_products);
}

Eigen::VectorXd DecreasesOfAll(const Projection& projection, const std::vector<int>& columns,
                               const Eigen::MatrixXd& projected_products) {
  constexpr double kRidge = 1e-6;  // of a column of length 1: a thousandth of it is not seen
  Scaled scaled = ToUnitLength(projection.gram()(columns, columns));
  scaled.gram.diagonal().array() += kRidge;
  const auto factor = TryCholesky(scaled.gram);
  if (!factor) return Eigen::VectorXd::Zero(projected_products.cols());
  const Eigen::MatrixXd white =
      factor->matrixL().solve(scaled.scale.asDiagonal() * projected_products);
  return white.colwise().squaredNorm();
}

double LargestCosine(const Projection& projection, const std::vector<int>& a,
                     const std::vector<int>& b) {
  const auto root = [&](const std::vector<int>& columns) -> Eigen::MatrixXd {
    const Scaled scaled = ToUnitLength(projection.gram()(columns, columns));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.gram);
    const double least = kUnseen * std::max(1e-300, eigen.eigenvalues().maxCoeff());
    const Eigen::VectorXd inverse =
        (eigen.eigenvalues().array() > least)
            .select(eigen.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse(), 0.0);
    return scaled.scale.asDiagonal() * eigen.eigenvectors() * inverse.asDiagonal();
  };
  const Eigen::MatrixXd cross = root(a).transpose() * projection.gram()(a, b) * root(b);
  if (cross.size() == 0) return 0.0;
  return std::min(1.0, Eigen::JacobiSVD<Eigen::MatrixXd>(cross).singularValues()[0]);
}

double TailProbability(const std::vector<double>& draws, double value) {
  const auto n = static_cast<double>(draws.size());
  const auto above = static_cast<double>(
      std::count_if(draws.begin(), draws.end(), [&](double d) { return d >= value; }));
  constexpr double kEnough = 10.0;
  if (above >= kEnough || draws.size() < 3) return (above + 1.0) / (n + 1.0);
  double mean = 0.0, variance = 0.0;
  for (const double d : draws) mean += std::cbrt(d) / n;
  for (const double d : draws) variance += std::pow(std::cbrt(d) - mean, 2) / (n - 1.0);
  if (!(variance > 0.0)) return value > mean * mean * mean ? 1.0 / (n + 1.0) : 1.0;
  const double z = (std::cbrt(value) - mean) / std::sqrt(variance);
  // Never above what counting allows.
  return std::min(0.5 * std::erfc(z / std::sqrt(2.0)), (above + 1.0) / (n + 1.0));
}

double NormalDeviate(double chi_squared, double freedom) {
  if (freedom <= 0.0) return 0.0;
  const double spread = 2.0 / (9.0 * freedom);
  return (std::cbrt(chi_squared / freedom) - (1.0 - spread)) / std::sqrt(spread);
}

std::vector<double> FalseDiscoveryRates(const std::vector<double>& p_values) {
  const std::size_t n = p_values.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> rates(n, 1.0);
  double least = 1.0;
  for (std::size_t i = n; i-- > 0;) {
    least =
        std::min(least, p_values[order[i]] * static_cast<double>(n) / static_cast<double>(i + 1));
    rates[order[i]] = least;
  }
  return rates;
}

}  // namespace clothfit
