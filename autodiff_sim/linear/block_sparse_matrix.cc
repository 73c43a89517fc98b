// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pattern and product of block-sparse matrices.
#include "autodiff_sim/linear/block_sparse_matrix.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "autodiff_sim/base/flush_denormals.h"

namespace clothfit {

int BlockPattern::Find(int row, int col) const {
  // Without branches, which could not be predicted.
  const int* first = column.data() + row_begin[row];
  for (int size = row_begin[row + 1] - row_begin[row]; size > 1;) {
    const int half = size / 2;
    first += first[half] <= col ? half : 0;
    size -= half;
  }
  return *first == col ? static_cast<int>(first - column.data()) : -1;
}

BlockPattern MakePattern(int num_particles, const std::vector<std::vector<int>>& cliques) {
  std::vector<std::set<int>> neighbours(num_particles);
  for (int i = 0; i < num_particles; ++i) neighbours[i].insert(i);
  for (const std::vector<int>& clique : cliques) {
    for (const int a : clique) neighbours[a].insert(clique.begin(), clique.end());
  }
  BlockPattern pattern;
  pattern.row_begin.push_back(0);
  for (const std::set<int>& row : neighbours) {
    const int i = static_cast<int>(pattern.diagonal.size());
    pattern.diagonal.push_back(pattern.num_blocks() +
                               static_cast<int>(std::distance(row.begin(), row.find(i))));
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_begin.push_back(pattern.num_blocks());
  }
  return pattern;
}

BlockPattern ExtendPattern(const BlockPattern& pattern,
                           const std::vector<std::vector<int>>& cliques) {
  std::vector<std::vector<int>> more(static_cast<std::size_t>(pattern.num_rows()));
  for (const std::vector<int>& clique : cliques) {
    for (const int a : clique) more[a].insert(more[a].end(), clique.begin(), clique.end());
  }
  BlockPattern extended;
  extended.row_begin.push_back(0);
  for (int i = 0; i < pattern.num_rows(); ++i) {
    std::vector<int>& row = more[i];
    row.insert(row.end(), pattern.column.begin() + pattern.row_begin[i],
               pattern.column.begin() + pattern.row_begin[i + 1]);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    const auto diagonal = std::lower_bound(row.begin(), row.end(), i);
    extended.diagonal.push_back(extended.num_blocks() +
                                static_cast<int>(std::distance(row.begin(), diagonal)));
    extended.column.insert(extended.column.end(), row.begin(), row.end());
    extended.row_begin.push_back(extended.num_blocks());
  }
  return extended;
}

template <int kColumns>
void BlockSparseMatrix::AddProduct(const Lanes<kColumns>& x, double scale,
                                   Lanes<kColumns>* y) const {
  using Row = Eigen::Matrix<double, 1, kColumns>;
  for (int row = 0; row < pattern_->num_rows(); ++row) {
    Row sum0 = Row::Zero(), sum1 = Row::Zero(), sum2 = Row::Zero();
    for (int k = pattern_->row_begin[row]; k < pattern_->row_begin[row + 1]; ++k) {
      const double *row0 = block(k), *row1 = row0 + kRow, *row2 = row1 + kRow;
      const int col = 3 * pattern_->column[k];
      const Row x0 = x.row(col), x1 = x.row(col + 1), x2 = x.row(col + 2);
      sum0 += row0[0] * x0 + row0[1] * x1 + row0[2] * x2;
      sum1 += row1[0] * x0 + row1[1] * x1 + row1[2] * x2;
      sum2 += row2[0] * x0 + row2[1] * x1 + row2[2] * x2;
    }
    y->row(3 * row) += scale * sum0;
    y->row(3 * row + 1) += scale * sum1;
    y->row(3 * row + 2) += scale * sum2;
  }
}

void FloatBlockMatrix::Round(const BlockSparseMatrix& a) {
  const FlushDenormals flush;
  float* rounded = values_.data();
  for (int k = 0; k < pattern_->num_blocks(); ++k, rounded += 12) {
    const double* block = a.block(k);
    for (int q = 0; q < 3; ++q) {
      for (int p = 0; p < 3; ++p)
        rounded[4 * q + p] = static_cast<float>(block[BlockSparseMatrix::kRow * p + q]);
    }
  }
}

template <>
void FloatBlockMatrix::Multiply<1>(const FloatLanes<1>& x, FloatLanes<1>* y) const {
  y->resize(x.rows());
  const float* block = values_.data();
  for (int row = 0; row < pattern_->num_rows(); ++row) {
    Eigen::Array4f even = Eigen::Array4f::Zero(), odd = even, last = even;
    for (int k = pattern_->row_begin[row]; k < pattern_->row_begin[row + 1]; ++k, block += 12) {
      const float* part = x.data() + 3 * pattern_->column[k];
      even += Eigen::Map<const Eigen::Array4f>(block) * part[0];
      odd += Eigen::Map<const Eigen::Array4f>(block + 4) * part[1];
      last += Eigen::Map<const Eigen::Array4f>(block + 8) * part[2];
    }
    y->segment<3>(3 * row) = (even + odd + last).head<3>();
  }
}

template <>
void FloatBlockMatrix::Multiply<kLanes>(const FloatLanes<kLanes>& x, FloatLanes<kLanes>* y) const {
  using Row = Eigen::Matrix<float, 1, kLanes>;
  y->resize(x.rows(), kLanes);
  const float* block = values_.data();
  for (int row = 0; row < pattern_->num_rows(); ++row) {
    Row sum0 = Row::Zero(), sum1 = sum0, sum2 = sum0;
    for (int k = pattern_->row_begin[row]; k < pattern_->row_begin[row + 1]; ++k, block += 12) {
      for (int q = 0; q < 3; ++q) {
        const Row part = x.row(3 * pattern_->column[k] + q);
        sum0 += block[4 * q] * part;
        sum1 += block[4 * q + 1] * part;
        sum2 += block[4 * q + 2] * part;
      }
    }
    y->row(3 * row) = sum0;
    y->row(3 * row + 1) = sum1;
    y->row(3 * row + 2) = sum2;
  }
}

template void BlockSparseMatrix::AddProduct<1>(const Lanes<1>&, double, Lanes<1>*) const;
template void BlockSparseMatrix::AddProduct<kLanes>(const Lanes<kLanes>&, double,
                                                    Lanes<kLanes>*) const;

}  // namespace clothfit
