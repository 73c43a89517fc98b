// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Eigen's SparseLU on a copy of the matrix: slow, and rarely called.
#include "autodiff_sim/linear/direct_solve.h"

#include <vector>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

namespace clothfit {
namespace {

Eigen::SparseMatrix<double> ToSparse(const BlockSparseMatrix& a) {
  const BlockPattern& pattern = a.pattern();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * static_cast<std::size_t>(pattern.num_blocks()));
  for (int row = 0; row < pattern.num_rows(); ++row) {
    for (int k = pattern.row_begin[row]; k < pattern.row_begin[row + 1]; ++k) {
      for (int e = 0; e < 9; ++e) {
        entries.emplace_back(3 * row + e / 3, 3 * pattern.column[k] + e % 3,
                             a.block(k)[BlockSparseMatrix::kRow * (e / 3) + e % 3]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(3 * pattern.num_rows(), 3 * pattern.num_rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

template <int kColumns>
bool SolveDirectly(const BlockSparseMatrix& a, const Lanes<kColumns>& b, Lanes<kColumns>* x) {
  if (!b.allFinite()) return false;
  const Eigen::SparseMatrix<double> matrix = ToSparse(a);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  lu.compute(matrix);
  if (lu.info() != Eigen::Success) return false;
  const Eigen::MatrixXd right = b;
  Eigen::MatrixXd solution = lu.solve(right);
  solution += lu.solve(right - matrix * solution);  // one step of iterative refinement
  *x = solution;
  return x->allFinite();
}

template bool SolveDirectly<1>(const BlockSparseMatrix&, const Lanes<1>&, Lanes<1>*);
template bool SolveDirectly<kLanes>(const BlockSparseMatrix&, const Lanes<kLanes>&, Lanes<kLanes>*);

}  // namespace clothfit
