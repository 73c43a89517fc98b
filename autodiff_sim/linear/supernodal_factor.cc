// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What both factorisations share. They look right: a panel is factored, then its product is
// subtracted from the panels after it.
#include "autodiff_sim/linear/supernodal_factor.h"

#include <algorithm>
#include <utility>

#include "autodiff_sim/base/flush_denormals.h"
#include "autodiff_sim/linear/dense_panel.h"

namespace clothfit {

SupernodalFactor::SupernodalFactor(std::shared_ptr<const Supernodes> supernodes)
    : supernodes_(std::move(supernodes)),
      lower_(supernodes_->num_values),
      inverse_diagonal_(3 * supernodes_->order.size()),
      product_(6 * static_cast<std::size_t>(supernodes_->largest_stride)) {}

void SupernodalFactor::ScatterProduct(const Panel& panel, const float* left, const float* right,
                                      float* all) {
  const int* rows = &supernodes_->rows[panel.rows];
  for (int t = panel.targets_begin; t < panel.targets_end; ++t) {
    const PanelTarget& target = supernodes_->targets[t];
    const Panel& after = supernodes_->panels[target.panel];
    const int* position = &supernodes_->positions[target.positions] - target.row_begin;
    int together = 2;
    for (int j = target.row_begin; j < target.row_end; j += together) {
      together = std::min(2, target.row_end - j);
      ProductColumns(3 * panel.width, panel.stride, left, right, 3 * j, 3 * together,
                     product_.data());
      for (int c = 0; c < 3 * together; ++c) {
        const float* product = &product_[static_cast<std::size_t>(c * panel.stride)];
        float* column =
            all + after.values + (3 * (rows[j + c / 3] - after.first) + c % 3) * after.stride;
        for (int i = j + c / 3; i < panel.height; ++i) {
          for (int p = 0; p < 3; ++p) column[3 * position[i] + p] -= product[3 * i + p];
        }
      }
    }
  }
}

template <int kColumns>
void SupernodalFactor::Solve(const FloatLanes<kColumns>& b, FloatLanes<kColumns>* x) const {
  const FlushDenormals flush;
  const std::vector<float>& upper = upper_.empty() ? lower_ : upper_;
  constexpr int kBlock = 3 * kColumns;  // numbers of a particle
  const std::vector<int>& order = supernodes_->order;
  // In elimination order; of one panel. Each thread has its own.
  thread_local std::vector<float> right_hand_side, gathered;
  right_hand_side.resize(kBlock * order.size());
  gathered.resize(kColumns * static_cast<std::size_t>(supernodes_->largest_stride));
  float *all = right_hand_side.data(), *part = gathered.data();
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(b.data() + kBlock * order[i], kBlock, all + kBlock * i);
  }
  for (const Panel& panel : supernodes_->panels) {
    const int* rows = &supernodes_->rows[panel.rows];
    float* own = all + kBlock * panel.first;
    std::copy_n(own, kBlock * panel.width, part);
    std::fill(part + kBlock * panel.width, part + kColumns * panel.stride, 0.0f);
    SolvePanelLower<kColumns>(3 * panel.width, panel.stride, &lower_[panel.values],
                              &inverse_diagonal_[3 * panel.first], part);
    std::copy_n(part, kBlock * panel.width, own);
    for (int i = panel.width; i < panel.height; ++i) {
      for (int p = 0; p < kBlock; ++p) all[kBlock * rows[i] + p] += part[kBlock * i + p];
    }
  }
  for (auto panel = supernodes_->panels.rbegin(); panel != supernodes_->panels.rend(); ++panel) {
    const int* rows = &supernodes_->rows[panel->rows];
    for (int i = 0; i < panel->height; ++i) {
      std::copy_n(all + kBlock * rows[i], kBlock, part + kBlock * i);
    }
    std::fill(part + kBlock * panel->height, part + kColumns * panel->stride, 0.0f);
    SolvePanelUpper<kColumns>(3 * panel->width, panel->stride, &upper[panel->values],
                              &inverse_diagonal_[3 * panel->first], part);
    std::copy_n(part, kBlock * panel->width, all + kBlock * panel->first);
  }
  x->resize(b.rows(), kColumns);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(all + kBlock * i, kBlock, x->data() + kBlock * order[i]);
  }
}

template void SupernodalFactor::Solve<1>(const FloatLanes<1>&, FloatLanes<1>*) const;
template void SupernodalFactor::Solve<kLanes>(const FloatLanes<kLanes>&, FloatLanes<kLanes>*) const;

}  // namespace clothfit
