// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// As sparse_cholesky.cc, with two panels for each of its one.
#include "autodiff_sim/linear/sparse_lu.h"

#include <algorithm>
#include <utility>

#include "autodiff_sim/base/flush_denormals.h"
#include "autodiff_sim/linear/dense_panel.h"

namespace clothfit {

SparseLu::SparseLu(std::shared_ptr<const Supernodes> supernodes)
    : SupernodalFactor(std::move(supernodes)) {
  upper_.resize(lower_.size());
}

void SparseLu::Gather(const BlockSparseMatrix& a) {
  std::fill(lower_.begin(), lower_.end(), 0.0f);
  std::fill(upper_.begin(), upper_.end(), 0.0f);
  for (const BlockPlace& place : supernodes_->places) {
    const double *block = a.block(place.block), *mirror = a.block(place.mirror);
    for (int q = 0; q < 3; ++q) {
      for (int p = 0; p < 3; ++p) {
        const std::size_t at = place.values + static_cast<std::size_t>(q * place.stride + p);
        lower_[at] = static_cast<float>(block[BlockSparseMatrix::kRow * p + q]);
        upper_[at] = static_cast<float>(mirror[BlockSparseMatrix::kRow * q + p]);
      }
    }
  }
}

bool SparseLu::Factorize(const BlockSparseMatrix& a) {
  const FlushDenormals flush;
  Gather(a);
  has_factor_ = false;
  for (const Panel& panel : supernodes_->panels) {
    float *lower = &lower_[panel.values], *upper = &upper_[panel.values];
    if (!FactorPanels(3 * panel.width, panel.stride, lower, upper,
                      &inverse_diagonal_[3 * static_cast<std::size_t>(panel.first)])) {
      return false;
    }
    ScatterProduct(panel, lower, upper, lower_.data());
    ScatterProduct(panel, upper, lower, upper_.data());
  }
  has_factor_ = true;
  return true;
}

}  // namespace clothfit
