// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Preconditioned GMRES for several right-hand sides with the same matrix. The Krylov spaces are
// built in single precision and the solution is refined in double precision, as in Carson and
// Higham 2018, so that speed is that of the one and accuracy that of the other.
#pragma once

#include <vector>

#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/linear/supernodal_factor.h"

namespace clothfit {

struct GmresOptions {
  double relative_tolerance = 1e-11;  // of |P^-1 r| to |x|, column by column; never absolute
  int max_iterations = 60;            // of all cycles together
  // The factor is of A itself, so that refinement without Krylov spaces does, as long as it does.
  bool factor_is_exact = false;
};

struct GmresReport {
  bool converged = false;
  int iterations = 0;
  double relative_residual = 0.0;  // the worst column's |P^-1 (b - A x)| / |x|, estimated
};

// P^-1 r, each column as a vector of ordinary size times `scale`: the squares of small numbers
// would leave the range of single precision.
template <int kColumns>
struct Preconditioned {
  Preconditioned() = default;
  Preconditioned(const SupernodalFactor& factor, const Lanes<kColumns>& r);

  FloatLanes<kColumns> z;
  Eigen::Array<double, 1, kColumns> scale;
};

class Gmres {
 public:
  explicit Gmres(const BlockPattern* pattern) : rounded_(pattern) {}

  // Sets A, which must stay as it is until it is set again.
  void SetMatrix(const BlockSparseMatrix* a) {
    matrix_ = a;
    rounded_.Round(*a);
  }

  // Solves A x = b, from the given x on, with the factor P of (about) A on the left, so that what
  // is minimised estimates the error of x itself. Each column has its own Krylov space; products
  // and triangular solves are done for all at once. A column with b = 0 gets x = 0. For 1 or kLanes
  // columns. Where x is zero and P^-1 b is known already it may be given as `first`.
  template <int kColumns>
  GmresReport Solve(const SupernodalFactor* preconditioner, const Lanes<kColumns>& b,
                    const GmresOptions& options, Lanes<kColumns>* x,
                    const Preconditioned<kColumns>* first = nullptr) const;

 private:
  const BlockSparseMatrix* matrix_ = nullptr;
  FloatBlockMatrix rounded_;
};

}  // namespace clothfit
