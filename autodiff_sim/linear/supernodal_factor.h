// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A matrix as the product of two triangular ones, L U, in dense panels of single precision: a
// preconditioner, never the last word.
#pragma once

#include <memory>
#include <vector>

#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/linear/supernodes.h"

namespace clothfit {

class SupernodalFactor {
 public:
  bool has_factor() const { return has_factor_; }
  const std::shared_ptr<const Supernodes>& supernodes() const { return supernodes_; }

  // x = (L U)^-1 b, for 1 or kLanes columns.
  template <int kColumns>
  void Solve(const FloatLanes<kColumns>& b, FloatLanes<kColumns>* x) const;

 protected:
  explicit SupernodalFactor(std::shared_ptr<const Supernodes> supernodes);

  // Subtracts from `target`'s panels after this one the product of its rows of `left` and the
  // transposed ones of `right`: their lower triangle.
  void ScatterProduct(const Panel& panel, const float* left, const float* right, float* target);

  std::shared_ptr<const Supernodes> supernodes_;
  // L and, where it is not L', the transpose of U, with the same diagonal; and that, inverted.
  std::vector<float> lower_, upper_, inverse_diagonal_;
  bool has_factor_ = false;

 private:
  std::vector<float> product_;  // six columns of a product
};

}  // namespace clothfit
