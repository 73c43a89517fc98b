// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// CHOLMOD does the ordering, the symbolic analysis and the factorisation. The triangular solves for
// kLanes columns walk its supernodes here, all columns in one vector register: CHOLMOD's own take
// three to five times as long for so few columns. They are tested against it.
#include "autodiff_sim/sparse_cholesky.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cholmod.h>

namespace clothfit {

struct SparseCholesky::Impl {
  cholmod_common common;
  cholmod_sparse* matrix = nullptr;  // lower triangle, columns compressed
  cholmod_factor* factor = nullptr;
  // For each stored entry of the lower triangle: where A has it and its mirror image.
  std::vector<std::size_t> entry, mirror;
  std::vector<int> permutation;
  Lanes<kLanes> permuted, gathered;

  ~Impl() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }

  void BuildMatrix(const BlockPattern& pattern);
  void SolveLower();
  void SolveUpper();
};

void SparseCholesky::Impl::BuildMatrix(const BlockPattern& pattern) {
  const int n = 3 * pattern.num_rows();
  std::vector<int> rows, begin = {0};
  for (int node = 0; node < pattern.num_rows(); ++node) {
    for (int q = 0; q < 3; ++q) {
      for (int k = pattern.row_begin[node]; k < pattern.row_begin[node + 1]; ++k) {
        const int other = pattern.column[k];
        if (other < node) continue;
        const std::size_t transposed = static_cast<std::size_t>(pattern.Find(other, node));
        for (int p = other == node ? q : 0; p < 3; ++p) {
          rows.push_back(3 * other + p);
          entry.push_back(9 * transposed + static_cast<std::size_t>(3 * p + q));
          mirror.push_back(9 * static_cast<std::size_t>(k) + static_cast<std::size_t>(3 * q + p));
        }
      }
      begin.push_back(static_cast<int>(rows.size()));
    }
  }
  matrix = cholmod_allocate_sparse(n, n, rows.size(), 1, 1, -1, CHOLMOD_REAL, &common);
  std::copy(rows.begin(), rows.end(), static_cast<int*>(matrix->i));
  std::copy(begin.begin(), begin.end(), static_cast<int*>(matrix->p));
  std::fill_n(static_cast<double*>(matrix->x), rows.size(), 0.0);
}

SparseCholesky::SparseCholesky(const BlockPattern* pattern) : impl_(std::make_unique<Impl>()) {
  cholmod_common& common = impl_->common;
  cholmod_start(&common);
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NESDIS;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.final_ll = 1;
  common.quick_return_if_not_posdef = 1;
  impl_->BuildMatrix(*pattern);
  impl_->factor = cholmod_analyze(impl_->matrix, &common);
  if (impl_->factor == nullptr) throw std::runtime_error("CHOLMOD: the analysis failed");
  const int* perm = static_cast<const int*>(impl_->factor->Perm);
  impl_->permutation.assign(perm, perm + impl_->factor->n);
}

SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::Factorize(const BlockSparseMatrix& a) {
  double* x = static_cast<double*>(impl_->matrix->x);
  const double* values = a.block(0);
  for (std::size_t k = 0; k < impl_->entry.size(); ++k) {
    x[k] = 0.5 * (values[impl_->entry[k]] + values[impl_->mirror[k]]);
  }
  // The scale of the ladder: the mean of the diagonal.
  const int* begin = static_cast<const int*>(impl_->matrix->p);
  double mean = 0.0;
  for (std::size_t j = 0; j < impl_->matrix->ncol; ++j) mean += std::abs(x[begin[j]]);
  mean /= static_cast<double>(impl_->matrix->ncol);
  has_factor_ = false;
  if (!std::isfinite(mean)) return false;
  constexpr double kSmallestShift = 1e-4, kLargestShift = 1e4, kGrowth = 4.0;
  for (double relative = 0.0; relative < kLargestShift;
       relative = relative == 0.0 ? kSmallestShift : kGrowth * relative) {
    shift_ = relative * mean;
    double beta[2] = {shift_, 0.0};
    ++num_factorizations_;
    cholmod_factorize_p(impl_->matrix, beta, nullptr, 0, impl_->factor, &impl_->common);
    if (impl_->common.status == CHOLMOD_OK && impl_->factor->minor == impl_->factor->n) {
      has_factor_ = true;
      return true;
    }
  }
  return false;
}

// L y = b in place on `permuted`, supernode after supernode.
void SparseCholesky::Impl::SolveLower() {
  using Row = Eigen::Matrix<double, 1, kLanes>;
  const int* super = static_cast<const int*>(factor->super);
  const int* row_begin = static_cast<const int*>(factor->pi);
  const int* value_begin = static_cast<const int*>(factor->px);
  const int* rows = static_cast<const int*>(factor->s);
  const double* values = static_cast<const double*>(factor->x);
  for (std::size_t s = 0; s < factor->nsuper; ++s) {
    const int first = super[s], width = super[s + 1] - first,
              height = row_begin[s + 1] - row_begin[s];
    const double* l = values + value_begin[s];
    const int* row = rows + row_begin[s];
    for (int j = 0; j < width; ++j) {
      Row y = permuted.row(first + j);
      for (int k = 0; k < j; ++k) y -= l[j + k * height] * permuted.row(first + k);
      permuted.row(first + j) = y / l[j + j * height];
    }
    // Four columns at a time, so that the row that they update is loaded once.
    int j = 0;
    for (; j + 4 <= width; j += 4) {
      const Row y0 = permuted.row(first + j), y1 = permuted.row(first + j + 1),
                y2 = permuted.row(first + j + 2), y3 = permuted.row(first + j + 3);
      const double *l0 = l + j * height, *l1 = l0 + height, *l2 = l1 + height, *l3 = l2 + height;
      for (int i = width; i < height; ++i) {
        permuted.row(row[i]) -= l0[i] * y0 + l1[i] * y1 + l2[i] * y2 + l3[i] * y3;
      }
    }
    for (; j < width; ++j) {
      const Row y = permuted.row(first + j);
      const double* column = l + j * height;
      for (int i = width; i < height; ++i) permuted.row(row[i]) -= column[i] * y;
    }
  }
}

// L' x = y in place on `permuted`.
void SparseCholesky::Impl::SolveUpper() {
  using Row = Eigen::Matrix<double, 1, kLanes>;
  const int* super = static_cast<const int*>(factor->super);
  const int* row_begin = static_cast<const int*>(factor->pi);
  const int* value_begin = static_cast<const int*>(factor->px);
  const int* rows = static_cast<const int*>(factor->s);
  const double* values = static_cast<const double*>(factor->x);
  for (std::size_t s = factor->nsuper; s-- > 0;) {
    const int first = super[s], width = super[s + 1] - first,
              height = row_begin[s + 1] - row_begin[s];
    const double* l = values + value_begin[s];
    const int* row = rows + row_begin[s];
    for (int i = width; i < height; ++i) gathered.row(i) = permuted.row(row[i]);
    for (int j = width - 1; j >= 0; --j) {
      const double* column = l + j * height;
      Row x = permuted.row(first + j), other = Row::Zero();
      int i = width;
      for (; i + 2 <= height; i += 2) {
        x -= column[i] * gathered.row(i);
        other -= column[i + 1] * gathered.row(i + 1);
      }
      if (i < height) x -= column[i] * gathered.row(i);
      for (int k = j + 1; k < width; ++k) other -= column[k] * permuted.row(first + k);
      permuted.row(first + j) = (x + other) / column[j];
    }
  }
}

template <>
void SparseCholesky::Solve<kLanes>(const Lanes<kLanes>& b, Lanes<kLanes>* x) {
  const int n = static_cast<int>(impl_->factor->n);
  impl_->permuted.resize(n, kLanes);
  impl_->gathered.resize(n, kLanes);
  for (int i = 0; i < n; ++i) impl_->permuted.row(i) = b.row(impl_->permutation[i]);
  impl_->SolveLower();
  impl_->SolveUpper();
  x->resize(n, kLanes);
  for (int i = 0; i < n; ++i) x->row(impl_->permutation[i]) = impl_->permuted.row(i);
}

template <>
void SparseCholesky::Solve<1>(const Lanes<1>& b, Lanes<1>* x) {
  cholmod_dense right{};
  right.nrow = right.d = static_cast<std::size_t>(b.size());
  right.ncol = 1;
  right.nzmax = right.nrow;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, impl_->factor, &right, &impl_->common);
  *x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), b.size());
  cholmod_free_dense(&solution, &impl_->common);
}

}  // namespace clothfit
