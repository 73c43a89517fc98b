// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The last resort where GMRES stalls, near a buckling point: an unsymmetric factorisation.
#pragma once

#include "autodiff_sim/linear/block_sparse_matrix.h"

namespace clothfit {

// Solves A x = b by sparse LU with partial pivoting. False where A is singular or not finite.
template <int kColumns>
bool SolveDirectly(const BlockSparseMatrix& a, const Lanes<kColumns>& b, Lanes<kColumns>* x);

extern template bool SolveDirectly<1>(const BlockSparseMatrix&, const Lanes<1>&, Lanes<1>*);
extern template bool SolveDirectly<kLanes>(const BlockSparseMatrix&, const Lanes<kLanes>&,
                                           Lanes<kLanes>*);

}  // namespace clothfit
