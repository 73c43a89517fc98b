// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Register-blocked loops. The vector types are GCC's and Clang's: whatever the machine has, the
// compiler splits or fuses them to.
#include "autodiff_sim/linear/dense_panel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "autodiff_sim/base/vector_width.h"

namespace clothfit {
namespace {

constexpr int kWide = kVectorBytes / 4;  // rows of a panel worked on at once
constexpr int kRounded = 16;             // strides are multiples of it, whatever the machine
static_assert(kRounded % kWide == 0);
typedef float Wide __attribute__((vector_size(kVectorBytes), aligned(4), may_alias));
typedef float Eight __attribute__((vector_size(32), aligned(4), may_alias));

const Wide& WideAt(const float* p) { return *reinterpret_cast<const Wide*>(p); }
Wide& WideAt(float* p) { return *reinterpret_cast<Wide*>(p); }
Eight& EightAt(float* p) { return *reinterpret_cast<Eight*>(p); }

float Sum(const Wide& v) {
  return Eigen::Map<const Eigen::Array<float, kWide, 1>>(reinterpret_cast<const float*>(&v)).sum();
}

// out = sign * out + sum_k a(:, k) b(c, k), for kWide kRows rows and kCols columns.
template <int kRows, int kCols, bool kSubtract>
void Tile(int depth, int stride, const float* a, const float* b, float* out) {
  Wide sum[kRows][kCols] = {};
  for (int k = 0; k < depth; ++k, a += stride, b += stride) {
    for (int r = 0; r < kRows; ++r) {
      const Wide row = WideAt(a + kWide * r);
      for (int c = 0; c < kCols; ++c) sum[r][c] += row * b[c];
    }
  }
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kCols; ++c) {
      Wide& target = WideAt(out + c * stride + kWide * r);
      target = kSubtract ? target - sum[r][c] : sum[r][c];
    }
  }
}

// The same for all rows from `begin`, a multiple of 16, on: four registers of sums a column where
// there are 32 registers, two where there are 16.
template <int kCols, bool kSubtract>
void TileColumn(int depth, int stride, const float* panel, int begin, const float* b, float* out) {
  constexpr int kRows = kVectorBytes == 64 ? 4 : 2;
  int i = begin;
  for (; i + kRows * kWide <= stride; i += kRows * kWide) {
    Tile<kRows, kCols, kSubtract>(depth, stride, panel + i, b, out + i);
  }
  switch ((stride - i) / kWide) {  // none where two registers hold 16 rows or less
    case 3:
      return Tile<3, kCols, kSubtract>(depth, stride, panel + i, b, out + i);
    case 2:
      return Tile<2, kCols, kSubtract>(depth, stride, panel + i, b, out + i);
    case 1:
      return Tile<1, kCols, kSubtract>(depth, stride, panel + i, b, out + i);
    default:
      return;
  }
}

int RoundDown(int row) { return row / kRounded * kRounded; }

// Takes column `before` of a strip out of column `column`, from row `begin` on.
void TakeOut(int begin, int stride, const float* before, float factor, float* column) {
  for (int i = begin; i < stride; i += kWide) WideAt(column + i) -= factor * WideAt(before + i);
}

// Divides by the pivot's root and clears what is above it.
void ScaleColumn(int begin, int pivot_row, int stride, float inverse, float* column) {
  for (int i = begin; i < stride; i += kWide) WideAt(column + i) *= inverse;
  std::fill(column + begin, column + pivot_row, 0.0f);
}

// Factors kCols columns from `first` on, to which all columns before have been applied.
template <int kCols>
bool FinishColumns(int first, int stride, float* strip, float* inverse_diagonal) {
  const int begin = RoundDown(first);
  for (int c = 0; c < kCols; ++c) {
    float* column = strip + c * stride;
    for (int k = 0; k < c; ++k) {
      const float* before = strip + k * stride;
      TakeOut(begin, stride, before, before[first + c], column);
    }
    const float pivot = column[first + c];
    if (!(pivot > 0.0f) || !std::isfinite(pivot)) return false;
    const float inverse = 1.0f / std::sqrt(pivot);
    ScaleColumn(begin, first + c, stride, inverse, column);
    inverse_diagonal[c] = inverse;
  }
  return true;
}

template <int kCols>
bool FactorColumns(int first, int stride, float* panel, float* inverse_diagonal) {
  float* strip = panel + static_cast<std::ptrdiff_t>(first) * stride;
  TileColumn<kCols, true>(first, stride, panel, RoundDown(first), panel + first, strip);
  return FinishColumns<kCols>(first, stride, strip, inverse_diagonal + first);
}

// As FactorColumns, of both panels.
template <int kCols>
bool FactorColumnPairs(int first, int stride, float* lower, float* upper, float* inverse_diagonal) {
  const int begin = RoundDown(first);
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(first) * stride;
  float *lower_strip = lower + offset, *upper_strip = upper + offset;
  TileColumn<kCols, true>(first, stride, lower, begin, upper + first, lower_strip);
  TileColumn<kCols, true>(first, stride, upper, begin, lower + first, upper_strip);
  for (int c = 0; c < kCols; ++c) {
    float *lower_column = lower_strip + c * stride, *upper_column = upper_strip + c * stride;
    for (int k = 0; k < c; ++k) {
      const float *l = lower_strip + k * stride, *u = upper_strip + k * stride;
      TakeOut(begin, stride, l, u[first + c], lower_column);
      TakeOut(begin, stride, u, l[first + c], upper_column);
    }
    const float pivot = lower_column[first + c];
    if (!(pivot > 0.0f) || !std::isfinite(pivot)) return false;
    const float inverse = 1.0f / std::sqrt(pivot);
    ScaleColumn(begin, first + c, stride, inverse, lower_column);
    ScaleColumn(begin, first + c, stride, inverse, upper_column);
    upper_column[first + c] = lower_column[first + c];  // but for rounding
    inverse_diagonal[first + c] = inverse;
  }
  return true;
}

// For the rows [row, row + kWide): t -= sum_k panel(:, k) t_k, k < depth.
void SubtractProductOfEight(int depth, int stride, const float* panel, int row, float* t) {
  Eight sum[kWide] = {};
  const float* l = panel + row;
  for (int k = 0; k < depth; ++k, l += stride) {
    const Eight y = EightAt(t + 8 * k);
    for (int r = 0; r < kWide; ++r) sum[r] += l[r] * y;
  }
  for (int r = 0; r < kWide; ++r) EightAt(t + 8 * (row + r)) -= sum[r];
}

// x for the kCols columns from `first` on, all after them being done.
template <int kCols>
void SolveUpperColumnsOfEight(int first, int stride, const float* panel,
                              const float* inverse_diagonal, float* t) {
  const float* strip = panel + static_cast<std::ptrdiff_t>(first) * stride;
  Eight sum[kCols] = {};
  for (int i = first + kCols; i < stride; ++i) {
    const Eight x = EightAt(t + 8 * i);
    for (int c = 0; c < kCols; ++c) sum[c] += strip[c * stride + i] * x;
  }
  for (int c = kCols - 1; c >= 0; --c) {
    Eight rest = EightAt(t + 8 * (first + c)) - sum[c];
    for (int k = c + 1; k < kCols; ++k) {
      rest -= strip[c * stride + first + k] * EightAt(t + 8 * (first + k));
    }
    EightAt(t + 8 * (first + c)) = rest * inverse_diagonal[first + c];
  }
}

}  // namespace

bool FactorPanels(int columns, int stride, float* lower, float* upper, float* inverse_diagonal) {
  int first = 0;
  for (; first + 6 <= columns; first += 6) {
    if (!FactorColumnPairs<6>(first, stride, lower, upper, inverse_diagonal)) return false;
  }
  return first == columns || FactorColumnPairs<3>(first, stride, lower, upper, inverse_diagonal);
}

bool FactorPanel(int columns, int stride, float* panel, float* inverse_diagonal) {
  int first = 0;
  for (; first + 6 <= columns; first += 6) {
    if (!FactorColumns<6>(first, stride, panel, inverse_diagonal)) return false;
  }
  return first == columns || FactorColumns<3>(first, stride, panel, inverse_diagonal);
}

void ProductColumns(int columns, int stride, const float* left, const float* right, int row,
                    int count, float* product) {
  if (count == 3) {
    TileColumn<3, false>(columns, stride, left, RoundDown(row), right + row, product);
  } else {
    TileColumn<6, false>(columns, stride, left, RoundDown(row), right + row, product);
  }
}

template <>
void SolvePanelLower<1>(int columns, int stride, const float* panel, const float* inverse_diagonal,
                        float* t) {
  for (int k = 0; k < columns; k += 3) {
    const float* l0 = panel + static_cast<std::ptrdiff_t>(k) * stride;
    const float *l1 = l0 + stride, *l2 = l1 + stride;
    const float y0 = t[k] * inverse_diagonal[k];
    const float y1 = (t[k + 1] - l0[k + 1] * y0) * inverse_diagonal[k + 1];
    const float y2 = (t[k + 2] - l0[k + 2] * y0 - l1[k + 2] * y1) * inverse_diagonal[k + 2];
    for (int i = RoundDown(k); i < stride; i += kWide) {
      WideAt(t + i) -= y0 * WideAt(l0 + i) + y1 * WideAt(l1 + i) + y2 * WideAt(l2 + i);
    }
    t[k] = y0;
    t[k + 1] = y1;
    t[k + 2] = y2;
  }
}

template <>
void SolvePanelUpper<1>(int columns, int stride, const float* panel, const float* inverse_diagonal,
                        float* t) {
  for (int k = columns - 3; k >= 0; k -= 3) {
    const float* l0 = panel + static_cast<std::ptrdiff_t>(k) * stride;
    const float *l1 = l0 + stride, *l2 = l1 + stride;
    const float t0 = t[k], t1 = t[k + 1], t2 = t[k + 2];
    t[k] = t[k + 1] = t[k + 2] = 0.0f;
    Wide sum0 = {}, sum1 = {}, sum2 = {};
    for (int i = RoundDown(k); i < stride; i += kWide) {
      const Wide x = WideAt(t + i);
      sum0 += x * WideAt(l0 + i);
      sum1 += x * WideAt(l1 + i);
      sum2 += x * WideAt(l2 + i);
    }
    t[k + 2] = (t2 - Sum(sum2)) * inverse_diagonal[k + 2];
    t[k + 1] = (t1 - Sum(sum1) - l1[k + 2] * t[k + 2]) * inverse_diagonal[k + 1];
    t[k] = (t0 - Sum(sum0) - l0[k + 1] * t[k + 1] - l0[k + 2] * t[k + 2]) * inverse_diagonal[k];
  }
}

template <>
void SolvePanelLower<8>(int columns, int stride, const float* panel, const float* inverse_diagonal,
                        float* t) {
  for (int row = 0; row < stride; row += kWide) {
    SubtractProductOfEight(std::min(row, columns), stride, panel, row, t);
    for (int k = row; k < std::min(row + kWide, columns); ++k) {
      const float* l = panel + static_cast<std::ptrdiff_t>(k) * stride;
      const Eight y = EightAt(t + 8 * k) * inverse_diagonal[k];
      EightAt(t + 8 * k) = y;
      for (int i = k + 1; i < row + kWide; ++i) EightAt(t + 8 * i) -= l[i] * y;
    }
  }
}

template <>
void SolvePanelUpper<8>(int columns, int stride, const float* panel, const float* inverse_diagonal,
                        float* t) {
  int first = columns;
  for (; first >= 12; first -= 12) {
    SolveUpperColumnsOfEight<12>(first - 12, stride, panel, inverse_diagonal, t);
  }
  for (; first > 0; first -= 3) {
    SolveUpperColumnsOfEight<3>(first - 3, stride, panel, inverse_diagonal, t);
  }
}

}  // namespace clothfit
