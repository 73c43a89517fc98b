// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A CHOLMOD factor of the symmetric part of a step's Jacobian, kept as preconditioner.
#pragma once

#include <memory>

#include "autodiff_sim/block_sparse_matrix.h"

namespace clothfit {

class SparseCholesky {
 public:
  // Analyses the pattern, once. The pattern must outlive this object.
  explicit SparseCholesky(const BlockPattern* pattern);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  // Factors (A + A') / 2 + shift I, with the smallest shift of a fixed ladder, from 0 on, that
  // makes it positive definite. Returns false where no shift does (NaN or infinity in A).
  bool Factorize(const BlockSparseMatrix& a);
  void Forget() { has_factor_ = false; }
  bool has_factor() const { return has_factor_; }
  double shift() const { return shift_; }
  int num_factorizations() const { return num_factorizations_; }

  // x = (L L')^-1 b.
  template <int kColumns>
  void Solve(const Lanes<kColumns>& b, Lanes<kColumns>* x);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  bool has_factor_ = false;
  double shift_ = 0.0;
  int num_factorizations_ = 0;
};

}  // namespace clothfit
