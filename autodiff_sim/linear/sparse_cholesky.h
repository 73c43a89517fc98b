// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A Cholesky factor of the symmetric part of a step's Jacobian, in single precision: a
// preconditioner, never the last word.
#pragma once

#include "autodiff_sim/linear/supernodal_factor.h"

namespace clothfit {

class SparseCholesky : public SupernodalFactor {
 public:
  // Analyses the pattern, once.
  explicit SparseCholesky(const BlockPattern* pattern,
                          Ordering ordering = Ordering::kNestedDissection);

  // Factors (A + A') / 2 + shift I, with a shift of a fixed ladder, from 0 on, that makes it
  // positive definite. The ladder is entered one rung below the last shift that was needed. Returns
  // false where no shift does (NaN or infinity in A).
  bool Factorize(const BlockSparseMatrix& a);
  // Forgets the factor and the shift, so that what follows does not depend on them.
  void Forget();
  // Begins on the other's rung: for a factor of much the same matrix with another pattern.
  void TakeShift(const SparseCholesky& other) { rung_ = other.rung_; }
  double shift() const { return shift_; }
  int num_factorizations() const { return num_factorizations_; }

 private:
  void Gather(const BlockSparseMatrix& a, float shift);
  bool FactorPanels();

  int rung_ = 0;
  double shift_ = 0.0;
  int num_factorizations_ = 0;
};

}  // namespace clothfit
