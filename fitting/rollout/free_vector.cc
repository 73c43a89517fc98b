// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/free_vector.h"

#include <cmath>

namespace clothfit {

Eigen::VectorXd FreeVector::PriorResiduals(const Eigen::VectorXd& theta) const {
  return prior_jacobian_ * theta - prior_target_;
}

std::vector<int> FreeVector::Fabric() const {
  std::vector<int> fabric;
  for (int i = 0; i < size(); ++i) {
    if (entries_[i].kind == FreeEntry::Kind::kParameter) fabric.push_back(i);
  }
  return fabric;
}

Eigen::VectorXd FreeVector::lower() const {
  Eigen::VectorXd bounds(size());
  for (int i = 0; i < size(); ++i) bounds[i] = entries_[i].lower;
  return bounds;
}

Eigen::VectorXd FreeVector::upper() const {
  Eigen::VectorXd bounds(size());
  for (int i = 0; i < size(); ++i) bounds[i] = entries_[i].upper;
  return bounds;
}

double FreeVector::UnitValue(int entry, double theta) const {
  const FreeEntry& one = entries_[entry];
  if (!one.is_log) return theta;
  if (theta == one.lower) return one.least;
  return theta == one.upper ? one.most : std::exp(theta);
}

}  // namespace clothfit
