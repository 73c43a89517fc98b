// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Preconditioned GMRES for several right-hand sides with the same matrix.
#pragma once

#include "autodiff_sim/block_sparse_matrix.h"
#include "autodiff_sim/sparse_cholesky.h"

namespace clothfit {

struct GmresOptions {
  double relative_tolerance = 1e-11;  // of |P^-1 r| to |P^-1 b|, column by column; never absolute
  int max_iterations = 60;
};

struct GmresReport {
  bool converged = false;
  int iterations = 0;
  double relative_residual = 0.0;  // the worst column's |P^-1 (b - A x)| / |P^-1 b|
};

// Solves A x = b, from the given x on, with the factor P of (about) A on the left, so that what is
// minimised estimates the error of x itself. Each column has its own Krylov space; the products and
// triangular solves are done for all at once. A column with b = 0 gets x = 0.
template <int kColumns>
GmresReport SolveGmres(const BlockSparseMatrix& a, SparseCholesky* preconditioner,
                       const Lanes<kColumns>& b, const GmresOptions& options, Lanes<kColumns>* x);

extern template GmresReport SolveGmres<1>(const BlockSparseMatrix&, SparseCholesky*,
                                          const Lanes<1>&, const GmresOptions&, Lanes<1>*);
extern template GmresReport SolveGmres<kLanes>(const BlockSparseMatrix&, SparseCholesky*,
                                               const Lanes<kLanes>&, const GmresOptions&,
                                               Lanes<kLanes>*);

}  // namespace clothfit
