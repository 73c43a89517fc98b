// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What code that is templated on its scalar shares: double, ceres::Jet or Dual.
#pragma once

#include <Eigen/Core>
#include <ceres/jet.h>

namespace clothfit {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// The plain value of a scalar that may carry derivatives.
inline double Value(double value) { return value; }
template <class T, int N>
double Value(const ceres::Jet<T, N>& value) {
  return value.a;
}

}  // namespace clothfit
