// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The dense kernels of a supernodal factor, in single precision: a panel is a column-major matrix
// of `columns` columns, `stride` numbers each, stride a multiple of 16. Its first rows are the
// lower triangle of its own columns (above the diagonal there are zeros), then come the rows below.
// BLAS calls cost more than they compute at these sizes (panels of 10 x 30 to 200 x 200).
#pragma once

namespace clothfit {

// A = L L' on the first `columns` rows and L21 = A21 L^-T below, in place; writes the inverses of
// L's diagonal. Returns false where a pivot is not positive.
bool FactorPanel(int columns, int stride, float* panel, float* inverse_diagonal);

// A = L U on the first `columns` rows, where `lower` holds A's lower triangle and what is below it,
// `upper` the transpose of its upper triangle and of what is right of it; in place, U transposed
// likewise. L and U have the same diagonal. Returns false where a pivot is not positive.
bool FactorPanels(int columns, int stride, float* lower, float* upper, float* inverse_diagonal);

// product(i, c) = sum_k left(i, k) right(row + c, k) for the `count` (3 or 6) rows from `row` on:
// columns of the product with the transpose, from row `row` rounded down to a multiple of 16 on,
// `stride` numbers each.
void ProductColumns(int columns, int stride, const float* left, const float* right, int row,
                    int count, float* product);

// L y = t for the first rows, t2 -= L21 y for the others, in place. kColumns (1 or 8) right-hand
// sides, row after row.
template <int kColumns>
void SolvePanelLower(int columns, int stride, const float* panel, const float* inverse_diagonal,
                     float* t);
// L' x = t1 - L21' t2, in place; leaves t2 as it is.
template <int kColumns>
void SolvePanelUpper(int columns, int stride, const float* panel, const float* inverse_diagonal,
                     float* t);

}  // namespace clothfit
