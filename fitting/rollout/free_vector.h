// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A vector that a fit moves: what its entries are, where they begin and what is known of them
// before.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

struct FreeEntry {
  enum class Kind { kParameter, kHandle, kInitialPosition, kInitialVelocity };
  Kind kind;
  std::string name;  // term.parameter, handle.NAME.x[3], initial.position.z[2], ...
  std::string unit;
  bool is_log = false;
  // Where it acts: index in the table of parameters; or handle, control point and coordinate; or
  // polynomial and coordinate.
  int index = 0, control = 0, axis = 0;
  double lower, upper;             // in the vector's own scale
  double least = 0.0, most = 0.0;  // a parameter's bounds in its unit, which exp(log) misses
  double prior, prior_sigma;       // in the vector's own scale
};

class FreeVector {
 public:
  int size() const { return static_cast<int>(entries_.size()); }
  const std::vector<FreeEntry>& entries() const { return entries_; }
  const Eigen::VectorXd& start() const { return start_; }
  // The entries that are physical parameters: the fabric's.
  std::vector<int> Fabric() const;
  // The entries' bounds, which may be infinite.
  Eigen::VectorXd lower() const;
  Eigen::VectorXd upper() const;

  // Prior residuals (unit variance), prior_jacobian * theta - prior_target: each entry's own prior,
  // and the smoothness of unknown paths.
  Eigen::VectorXd PriorResiduals(const Eigen::VectorXd& theta) const;
  const Eigen::MatrixXd& prior_jacobian() const { return prior_jacobian_; }
  const Eigen::VectorXd& prior_target() const { return prior_target_; }

  // The value in the entry's unit; at a bound it is the bound to the bit, so that what a fit found
  // may be given to another.
  double UnitValue(int entry, double theta) const;

 protected:
  FreeVector() = default;
  ~FreeVector() = default;

  std::vector<FreeEntry> entries_;
  Eigen::VectorXd start_;
  Eigen::MatrixXd prior_jacobian_;
  Eigen::VectorXd prior_target_;
};

}  // namespace clothfit
