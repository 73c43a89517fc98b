// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A square sparse matrix of 3 x 3 blocks, one block row a particle, with a symmetric pattern.
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// Several columns worked on at once: a row of them fits the vector registers. Row-major, 3N x
// kLanes.
constexpr int kLanes = 8;
template <int kColumns>
using Lanes = Eigen::Matrix<double, Eigen::Dynamic, kColumns,
                            kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
template <int kColumns>
using FloatLanes = Eigen::Matrix<float, Eigen::Dynamic, kColumns,
                                 kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

// The pattern, shared by all matrices of a simulation.
struct BlockPattern {
  std::vector<int> row_begin;  // num_rows + 1 offsets into `column`
  std::vector<int> column;     // block columns, ascending within a row, the diagonal always present
  std::vector<int> diagonal;   // index of each row's diagonal block

  int num_rows() const { return static_cast<int>(row_begin.size()) - 1; }
  int num_blocks() const { return static_cast<int>(column.size()); }
  // Index of the block at (row, column); -1 where the pattern has none.
  int Find(int row, int col) const;
};

// The pattern in which every two particles of a clique are coupled.
BlockPattern MakePattern(int num_particles, const std::vector<std::vector<int>>& cliques);

// The same with more couplings.
BlockPattern ExtendPattern(const BlockPattern& pattern,
                           const std::vector<std::vector<int>>& cliques);

class BlockSparseMatrix {
 public:
  // Numbers from one row of a block to the next: three and one that means nothing, so that a row is
  // added to at once.
  static constexpr int kRow = 4;

  explicit BlockSparseMatrix(const BlockPattern* pattern)
      : pattern_(pattern), rows_(3 * static_cast<std::size_t>(pattern->num_blocks())) {}

  const BlockPattern& pattern() const { return *pattern_; }
  void SetZero() { std::fill(rows_.begin(), rows_.end(), BlockRow()); }

  // The block with this index, its rows kRow numbers apart.
  double* block(int index) { return rows_[3 * static_cast<std::size_t>(index)].value; }
  const double* block(int index) const { return rows_[3 * static_cast<std::size_t>(index)].value; }

  // y += scale * A x.
  template <int kColumns>
  void AddProduct(const Lanes<kColumns>& x, double scale, Lanes<kColumns>* y) const;

 private:
  struct alignas(32) BlockRow {
    double value[kRow] = {};
  };
  const BlockPattern* pattern_;
  std::vector<BlockRow> rows_;  // three a block
};

// A rounded copy for iterations whose result is corrected in double precision.
class FloatBlockMatrix {
 public:
  explicit FloatBlockMatrix(const BlockPattern* pattern)
      : pattern_(pattern), values_(12 * static_cast<std::size_t>(pattern->num_blocks()), 0.0f) {}

  void Round(const BlockSparseMatrix& a);

  // y = A x, for 1 or kLanes columns.
  template <int kColumns>
  void Multiply(const FloatLanes<kColumns>& x, FloatLanes<kColumns>* y) const;

 private:
  const BlockPattern* pattern_;
  std::vector<float> values_;  // 12 a block: its columns, each filled up with a zero
};

extern template void BlockSparseMatrix::AddProduct<1>(const Lanes<1>&, double, Lanes<1>*) const;
extern template void BlockSparseMatrix::AddProduct<kLanes>(const Lanes<kLanes>&, double,
                                                           Lanes<kLanes>*) const;

}  // namespace clothfit
