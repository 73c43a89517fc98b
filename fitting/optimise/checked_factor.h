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
  // Of each diagonal entry, above what rounding makes of a pivot that is zero: to Eigen one below
  // zero, or another one behind it, is a failure.
  constexpr double kRidge = 1e-13;
  typename Derived::PlainObject raised = matrix;
  raised.diagonal() *= 1.0 + kRidge;
  const Eigen::LDLT<typename Derived::PlainObject> factor(raised);
  if (factor.info() != Eigen::Success || !factor.matrixLDLT().allFinite()) return {};
  const auto& pivots = factor.vectorD();
  const bool is_usable =
      matrix.size() == 0 || pivots.minCoeff() >= -kRounding * pivots.cwiseAbs().maxCoeff();
  return is_usable ? std::make_optional(factor) : std::nullopt;
}

}  // namespace clothfit
