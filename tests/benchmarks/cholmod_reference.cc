// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/cholmod_reference.h"

#include <algorithm>
#include <ctime>

namespace clothfit {

double Now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

CholmodReference::CholmodReference(const BlockPattern& pattern) {
  cholmod_start(&common_);
  common_.print = 0;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_NESDIS;
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.quick_return_if_not_posdef = 1;
  std::vector<int> rows, begin = {0};
  for (int node = 0; node < pattern.num_rows(); ++node) {
    for (int q = 0; q < 3; ++q) {
      for (int k = pattern.row_begin[node]; k < pattern.row_begin[node + 1]; ++k) {
        for (int p = 0; p < 3; ++p) {
          const int row = 3 * pattern.column[k] + p;
          if (row >= 3 * node + q) rows.push_back(row);
        }
      }
      begin.push_back(static_cast<int>(rows.size()));
    }
  }
  const auto n = static_cast<std::size_t>(3 * pattern.num_rows());
  matrix_ = cholmod_allocate_sparse(n, n, rows.size(), 1, 1, -1, CHOLMOD_REAL, &common_);
  std::copy(rows.begin(), rows.end(), static_cast<int*>(matrix_->i));
  std::copy(begin.begin(), begin.end(), static_cast<int*>(matrix_->p));
  factor_ = cholmod_analyze(matrix_, &common_);
}

CholmodReference::~CholmodReference() {
  cholmod_free_factor(&factor_, &common_);
  cholmod_free_sparse(&matrix_, &common_);
  cholmod_finish(&common_);
}

double CholmodReference::Factorize(const BlockSparseMatrix& a) {
  const BlockPattern& pattern = a.pattern();
  constexpr int kRow = BlockSparseMatrix::kRow;
  double* x = static_cast<double*>(matrix_->x);
  for (int node = 0; node < pattern.num_rows(); ++node) {
    for (int q = 0; q < 3; ++q) {
      for (int k = pattern.row_begin[node]; k < pattern.row_begin[node + 1]; ++k) {
        const double* mirror = a.block(pattern.Find(pattern.column[k], node));
        for (int p = 0; p < 3; ++p) {
          if (3 * pattern.column[k] + p >= 3 * node + q)
            *x++ = 0.5 * (a.block(k)[kRow * q + p] + mirror[kRow * p + q]);
        }
      }
    }
  }
  const double start = Now();
  cholmod_factorize(matrix_, factor_, &common_);
  return Now() - start;
}

}  // namespace clothfit
