// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Normal equations of residuals on the cloth: thousands of them meet in a few hundred particles, so
// that they are summed up by particles first and by what moves the particles after that.
#pragma once

#include <vector>

#include "autodiff_sim/step/state.h"
#include "fitting/residuals/point_residual.h"

namespace clothfit {

// r'r, P'r and P'P of residuals r with derivatives P by the particles' positions. P'P has 3 x 3
// blocks where particles share a triangle.
class NodeSums {
 public:
  explicit NodeSums(const ClothMesh& mesh);

  // Of these alone. Throws std::logic_error where a residual's particles share no triangle.
  void Set(const std::vector<PointResidual>& residuals);

  // Adds [J r]'[J r], J = P S the derivatives along the sensitivity's directions, to the lower
  // triangle of `sums`: as many rows as directions and one for r. The same numbers for any number
  // of threads.
  void AddTo(const Sensitivity& sensitivity, Eigen::MatrixXd* sums) const;

 private:
  // Particle `row`'s blocks are those from first_[row] on, with particles from column_[...]
  // that are not above it.
  int Find(int row, int column) const;
  // P'P times the columns of 3N values.
  Eigen::MatrixXd Multiply(const Eigen::Ref<const Eigen::MatrixXd>& values) const;

  std::vector<int> first_, column_;
  std::vector<Eigen::Matrix3d> blocks_;
  Eigen::VectorXd by_position_;  // P'r
  double squared_norm_ = 0.0;
};

}  // namespace clothfit
