// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A right-looking supernodal factorisation: each panel is factored, then its outer product is
// subtracted from the panels after it.
#include "autodiff_sim/sparse_cholesky.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/dense_panel.h"
#include "autodiff_sim/flush_denormals.h"

namespace clothfit {
namespace {

constexpr int kNumRungs = 16;

// The ladder of shifts, relative to the mean of the diagonal: 0, 1e-4, 4e-4, ...
double RelativeShift(int rung) { return rung == 0 ? 0.0 : 1e-4 * std::ldexp(1.0, 2 * (rung - 1)); }

}  // namespace

SparseCholesky::SparseCholesky(const BlockPattern* pattern, Ordering ordering)
    : supernodes_(FindSupernodes(*pattern, ordering)) {
  const std::size_t n = 3 * supernodes_.order.size();
  values_.resize(supernodes_.num_values);
  inverse_diagonal_.resize(n);
  product_.resize(6 * static_cast<std::size_t>(supernodes_.largest_stride));
}

void SparseCholesky::Forget() {
  has_factor_ = false;
  rung_ = 0;
}

bool SparseCholesky::Factorize(const BlockSparseMatrix& a) {
  const FlushDenormals flush;
  double mean = 0.0;
  for (int i = 0; i < a.pattern().num_rows(); ++i) {
    const double* block = a.block(a.pattern().diagonal[i]);
    mean += std::abs(block[0]) + std::abs(block[4]) + std::abs(block[8]);
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
  std::fill(values_.begin(), values_.end(), 0.0f);
  for (const BlockPlace& place : supernodes_.places) {
    const double *block = a.block(place.block), *mirror = a.block(place.mirror);
    float* target = &values_[place.values];
    for (int q = 0; q < 3; ++q) {
      for (int p = 0; p < 3; ++p) {
        target[q * place.stride + p] =
            static_cast<float>(0.5 * (block[3 * p + q] + mirror[3 * q + p]));
      }
      if (place.diagonal) target[q * place.stride + q] += shift;
    }
  }
}

bool SparseCholesky::FactorPanels() {
  for (const Panel& panel : supernodes_.panels) {
    if (!FactorPanel(3 * panel.width, panel.stride, &values_[panel.values],
                     &inverse_diagonal_[3 * static_cast<std::size_t>(panel.first)])) {
      return false;
    }
    ScatterOuterProduct(panel);
  }
  return true;
}

void SparseCholesky::ScatterOuterProduct(const Panel& panel) {
  const int* rows = &supernodes_.rows[panel.rows];
  for (int t = panel.targets_begin; t < panel.targets_end; ++t) {
    const PanelTarget& target = supernodes_.targets[t];
    const Panel& after = supernodes_.panels[target.panel];
    const int* position = &supernodes_.positions[target.positions] - target.row_begin;
    int together = 2;
    for (int j = target.row_begin; j < target.row_end; j += together) {
      together = std::min(2, target.row_end - j);
      OuterProductColumns(3 * panel.width, panel.stride, &values_[panel.values], 3 * j,
                          3 * together, product_.data());
      for (int c = 0; c < 3 * together; ++c) {
        const float* product = &product_[static_cast<std::size_t>(c * panel.stride)];
        float* column =
            &values_[after.values] + (3 * (rows[j + c / 3] - after.first) + c % 3) * after.stride;
        for (int i = j + c / 3; i < panel.height; ++i) {
          for (int p = 0; p < 3; ++p) column[3 * position[i] + p] -= product[3 * i + p];
        }
      }
    }
  }
}

template <int kColumns>
void SparseCholesky::Solve(const FloatLanes<kColumns>& b, FloatLanes<kColumns>* x) const {
  const FlushDenormals flush;
  constexpr int kBlock = 3 * kColumns;  // numbers of a particle
  const std::vector<int>& order = supernodes_.order;
  // In elimination order; of one panel. Each thread has its own.
  thread_local std::vector<float> right_hand_side, gathered;
  right_hand_side.resize(kBlock * order.size());
  gathered.resize(kColumns * static_cast<std::size_t>(supernodes_.largest_stride));
  float *all = right_hand_side.data(), *part = gathered.data();
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(b.data() + kBlock * order[i], kBlock, all + kBlock * i);
  }
  for (const Panel& panel : supernodes_.panels) {
    const int* rows = &supernodes_.rows[panel.rows];
    float* own = all + kBlock * panel.first;
    std::copy_n(own, kBlock * panel.width, part);
    std::fill(part + kBlock * panel.width, part + kColumns * panel.stride, 0.0f);
    SolvePanelLower<kColumns>(3 * panel.width, panel.stride, &values_[panel.values],
                              &inverse_diagonal_[3 * panel.first], part);
    std::copy_n(part, kBlock * panel.width, own);
    for (int i = panel.width; i < panel.height; ++i) {
      for (int p = 0; p < kBlock; ++p) all[kBlock * rows[i] + p] += part[kBlock * i + p];
    }
  }
  for (auto panel = supernodes_.panels.rbegin(); panel != supernodes_.panels.rend(); ++panel) {
    const int* rows = &supernodes_.rows[panel->rows];
    for (int i = 0; i < panel->height; ++i) {
      std::copy_n(all + kBlock * rows[i], kBlock, part + kBlock * i);
    }
    std::fill(part + kBlock * panel->height, part + kColumns * panel->stride, 0.0f);
    SolvePanelUpper<kColumns>(3 * panel->width, panel->stride, &values_[panel->values],
                              &inverse_diagonal_[3 * panel->first], part);
    std::copy_n(part, kBlock * panel->width, all + kBlock * panel->first);
  }
  x->resize(b.rows(), kColumns);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(all + kBlock * i, kBlock, x->data() + kBlock * order[i]);
  }
}

template void SparseCholesky::Solve<1>(const FloatLanes<1>&, FloatLanes<1>*) const;
template void SparseCholesky::Solve<kLanes>(const FloatLanes<kLanes>&, FloatLanes<kLanes>*) const;

}  // namespace clothfit
