// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The symmetric part gathered, then factored panel by panel.
#include "autodiff_sim/linear/sparse_cholesky.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/flush_denormals.h"
#include "autodiff_sim/linear/dense_panel.h"

namespace clothfit {
namespace {

constexpr int kNumRungs = 16;

// The ladder of shifts, relative to the mean of the diagonal: 0, 1e-4, 4e-4, ...
double RelativeShift(int rung) { return rung == 0 ? 0.0 : 1e-4 * std::ldexp(1.0, 2 * (rung - 1)); }

}  // namespace

SparseCholesky::SparseCholesky(const BlockPattern* pattern, Ordering ordering)
    : SupernodalFactor(std::make_shared<const Supernodes>(FindSupernodes(*pattern, ordering))) {}

void SparseCholesky::Forget() {
  has_factor_ = false;
  rung_ = 0;
}

bool SparseCholesky::Factorize(const BlockSparseMatrix& a) {
  const FlushDenormals flush;
  double mean = 0.0;
  for (int i = 0; i < a.pattern().num_rows(); ++i) {
    const double* block = a.block(a.pattern().diagonal[i]);
    for (int k = 0; k < 3; ++k) mean += std::abs(block[(BlockSparseMatrix::kRow + 1) * k]);
  }
  mean /= 3.0 * a.pattern().num_rows();
  has_factor_ = false;
  if (!std::isfinite(mean)) return false;
  for (rung_ = std::max(0, rung_ - 1); rung_ < kNumRungs; ++rung_) {
    shift_ = RelativeShift(rung_) * mean;
    ++num_factorizations_;
    Gather(a, static_cast<float>(shift_));
    if (FactorPanels()) {
      has_factor_ = true;
      return true;
    }
  }
  rung_ = 0;
  return false;
}

void SparseCholesky::Gather(const BlockSparseMatrix& a, float shift) {
  constexpr int kRow = BlockSparseMatrix::kRow;
  std::fill(lower_.begin(), lower_.end(), 0.0f);
  for (const BlockPlace& place : supernodes_->places) {
    const double *block = a.block(place.block), *mirror = a.block(place.mirror);
    float* target = &lower_[place.values];
    for (int q = 0; q < 3; ++q) {
      for (int p = 0; p < 3; ++p) {
        target[q * place.stride + p] =
            static_cast<float>(0.5 * (block[kRow * p + q] + mirror[kRow * q + p]));
      }
      if (place.diagonal) target[q * place.stride + q] += shift;
    }
  }
}

bool SparseCholesky::FactorPanels() {
  for (const Panel& panel : supernodes_->panels) {
    float* lower = &lower_[panel.values];
    if (!FactorPanel(3 * panel.width, panel.stride, lower,
                     &inverse_diagonal_[3 * static_cast<std::size_t>(panel.first)])) {
      return false;
    }
    ScatterProduct(panel, lower, lower, lower_.data());
  }
  return true;
}

}  // namespace clothfit
