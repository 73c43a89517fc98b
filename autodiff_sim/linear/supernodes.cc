// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// CHOLMOD analyses the pattern of blocks, which is nine times smaller than that of numbers.
#include "autodiff_sim/linear/supernodes.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include <cholmod.h>

namespace clothfit {
namespace {

// CHOLMOD's analysis, freed at the end of its life.
struct Analysis {
  Analysis(const BlockPattern& pattern, Ordering ordering) {
    cholmod_start(&common);
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = ordering == Ordering::kMinimumDegree ? CHOLMOD_AMD : CHOLMOD_NESDIS;
    common.supernodal = CHOLMOD_SUPERNODAL;
    const auto n = static_cast<std::size_t>(pattern.num_rows());
    matrix =
        cholmod_allocate_sparse(n, n, pattern.column.size(), 1, 1, -1, CHOLMOD_PATTERN, &common);
    std::copy(pattern.column.begin(), pattern.column.end(), static_cast<int*>(matrix->i));
    std::copy(pattern.row_begin.begin(), pattern.row_begin.end(), static_cast<int*>(matrix->p));
    {
      // METIS seeds the C library's random numbers and draws from them, which all threads share:
      // the order would depend on what others find at the same time.
      static std::mutex one_at_a_time;
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      factor = cholmod_analyze(matrix, &common);
    }
    if (factor == nullptr) throw std::runtime_error("CHOLMOD: the analysis failed");
  }
  ~Analysis() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  cholmod_common common;
  cholmod_sparse* matrix;  // with both triangles, of which CHOLMOD reads the lower
  cholmod_factor* factor;
};

void AddPanels(const cholmod_factor& factor, Supernodes* supernodes) {
  const int* super = static_cast<const int*>(factor.super);
  const int* row_begin = static_cast<const int*>(factor.pi);
  const int* rows = static_cast<const int*>(factor.s);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    Panel panel{};
    panel.first = super[s];
    panel.width = super[s + 1] - super[s];
    panel.height = row_begin[s + 1] - row_begin[s];
    panel.rows = static_cast<int>(supernodes->rows.size());
    panel.stride = (3 * panel.height + kRegister - 1) / kRegister * kRegister;
    panel.values = supernodes->num_values;
    supernodes->num_values += static_cast<std::size_t>(3 * panel.width * panel.stride);
    supernodes->largest_stride = std::max(supernodes->largest_stride, panel.stride);
    supernodes->rows.insert(supernodes->rows.end(), rows + row_begin[s], rows + row_begin[s + 1]);
    supernodes->panels.push_back(panel);
  }
}

// The row of a panel that holds this particle.
int FindRow(const Supernodes& supernodes, const Panel& panel, int particle) {
  const auto begin = supernodes.rows.begin() + panel.rows, end = begin + panel.height;
  return static_cast<int>(std::lower_bound(begin, end, particle) - begin);
}

void AddTargets(const std::vector<int>& panel_of, Supernodes* supernodes) {
  for (Panel& panel : supernodes->panels) {
    panel.targets_begin = static_cast<int>(supernodes->targets.size());
    const int* rows = &supernodes->rows[panel.rows];
    for (int begin = panel.width, end = begin; begin < panel.height; begin = end) {
      const int index = panel_of[rows[begin]];
      while (end < panel.height && panel_of[rows[end]] == index) ++end;
      supernodes->targets.push_back(
          {index, begin, end, static_cast<int>(supernodes->positions.size())});
      for (int i = begin; i < panel.height; ++i) {
        supernodes->positions.push_back(FindRow(*supernodes, supernodes->panels[index], rows[i]));
      }
    }
    panel.targets_end = static_cast<int>(supernodes->targets.size());
  }
}

void AddPlaces(const BlockPattern& pattern, const std::vector<int>& panel_of,
               Supernodes* supernodes) {
  std::vector<int> rank(supernodes->order.size());
  for (std::size_t i = 0; i < rank.size(); ++i) rank[supernodes->order[i]] = static_cast<int>(i);
  for (int node = 0; node < pattern.num_rows(); ++node) {
    for (int k = pattern.row_begin[node]; k < pattern.row_begin[node + 1]; ++k) {
      const int row = rank[node], column = rank[pattern.column[k]];
      if (row < column) continue;
      const Panel& panel = supernodes->panels[panel_of[column]];
      const int offset =
          3 * (column - panel.first) * panel.stride + 3 * FindRow(*supernodes, panel, row);
      supernodes->places.push_back({k, pattern.Find(pattern.column[k], node),
                                    panel.values + static_cast<std::size_t>(offset), panel.stride,
                                    row == column});
    }
  }
}

}  // namespace

Supernodes FindSupernodes(const BlockPattern& pattern, Ordering ordering) {
  const Analysis analysis(pattern, ordering);
  Supernodes supernodes;
  const int* order = static_cast<const int*>(analysis.factor->Perm);
  supernodes.order.assign(order, order + analysis.factor->n);
  AddPanels(*analysis.factor, &supernodes);
  std::vector<int> panel_of(supernodes.order.size());
  for (std::size_t s = 0; s < supernodes.panels.size(); ++s) {
    const Panel& panel = supernodes.panels[s];
    std::fill_n(panel_of.begin() + panel.first, panel.width, static_cast<int>(s));
  }
  AddTargets(panel_of, &supernodes);
  AddPlaces(pattern, panel_of, &supernodes);
  return supernodes;
}

}  // namespace clothfit
