// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Factors of symmetric matrices that are never used where there are none: Eigen's go on with what
// they have got and leave it to the caller to ask.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

namespace clothfit {

// L of L L' = matrix, of which the lower triangle is read. Empty where it is not positive definite
// or not finite.
template <class Derived>
std::optional<Eigen::LLT<typename Derived::PlainObject>> TryCholesky(
    const Eigen::MatrixBase<Derived>& matrix) {
  const Eigen::LLT<typename Derived::PlainObject> factor(matrix);
  // Whatever is not finite comes to the diagonal, and is no failure to Eigen.
  const bool is_usable =
      factor.info() == Eigen::Success && factor.matrixLLT().diagonal().allFinite();
  return is_usable ? std::make_optional(factor) : std::nullopt;
}

// The same; throws std::runtime_error that says of what where there is none.
template <class Derived>
Eigen::LLT<typename Derived::PlainObject> Cholesky(const Eigen::MatrixBase<Derived>& matrix,
                                                   const std::string& what) {
  auto factor = TryCholesky(matrix);
  if (!factor) throw std::runtime_error(what + " cannot be factored: not positive definite");
  return *std::move(factor);
}

// P' L D L' P = matrix, which may be singular. Empty where it is clearly not positive semidefinite,
// or not finite.
template <class Derived>
std::optional<Eigen::LDLT<typename Derived::PlainObject>> TrySemidefinite(
    const Eigen::MatrixBase<Derived>& matrix) {
  constexpr double kRounding = 1e-10;  // of the largest pivot
  const Eigen::LDLT<typename Derived::PlainObject> factor(matrix);
  if (factor.info() != Eigen::Success || !factor.matrixLDLT().allFinite()) return {};
  const auto& pivots = factor.vectorD();
  const bool is_usable =
      matrix.size() == 0 || pivots.minCoeff() >= -kRounding * pivots.cwiseAbs().maxCoeff();
  return is_usable ? std::make_optional(factor) : std::nullopt;
}

// Upper triangular R with R'R = rows' rows and no negative diagonal: Cholesky's factor without the
// sums of squares, which rounding makes indefinite where columns differ by more than eight digits
// (Bierman 1977, square-root information). Columns that depend on others leave zeros.
inline Eigen::MatrixXd TriangularRoot(const Eigen::MatrixXd& rows) {
  const Eigen::Index n = rows.cols();
  if (n == 0) return {};  // which Eigen does not decompose
  Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(std::max(rows.rows(), n), n);
  padded.topRows(rows.rows()) = rows;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(std::move(padded));
  Eigen::MatrixXd root = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (root(i, i) < 0.0) root.row(i) *= -1.0;
  }
  return root;
}

}  // namespace clothfit
