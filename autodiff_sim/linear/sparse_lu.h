// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The factors of a step's whole Jacobian, friction's and drag's asymmetry included. They cost twice
// what Cholesky's of its symmetric part does, and pay where many right-hand sides share them:
// GMRES then takes the iterations that single precision wants, whatever the physics.
#pragma once

#include <memory>

#include "autodiff_sim/linear/supernodal_factor.h"

namespace clothfit {

class SparseLu : public SupernodalFactor {
 public:
  // With the elimination order and panels of a Cholesky factor: the pattern is symmetric.
  explicit SparseLu(std::shared_ptr<const Supernodes> supernodes);

  // Factors A without pivoting, as is safe where its symmetric part is positive definite. Returns
  // false where a pivot is not positive.
  bool Factorize(const BlockSparseMatrix& a);

 private:
  void Gather(const BlockSparseMatrix& a);
};

}  // namespace clothfit
