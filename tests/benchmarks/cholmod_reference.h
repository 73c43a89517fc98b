// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The unit F of the benchmarks: one numerical factorisation by CHOLMOD, supernodal, in double
// precision, ordered by nested dissection, of the symmetric part of a step's Jacobian.
#pragma once

#include <vector>

#include <cholmod.h>

#include "autodiff_sim/linear/block_sparse_matrix.h"

namespace clothfit {

class CholmodReference {
 public:
  explicit CholmodReference(const BlockPattern& pattern);
  ~CholmodReference();
  CholmodReference(const CholmodReference&) = delete;
  CholmodReference& operator=(const CholmodReference&) = delete;

  // Seconds that the factorisation takes.
  double Factorize(const BlockSparseMatrix& a);

 private:
  cholmod_common common_;
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
};

// Seconds that this thread has computed: what other processes do does not count.
double Now();

}  // namespace clothfit
