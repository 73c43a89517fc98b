// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The solver's own linear algebra beside Eigen's dense one, on matrices like a step's.
#include <atomic>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/dual.h"
#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/linear/gmres.h"
#include "autodiff_sim/linear/sparse_cholesky.h"
#include "autodiff_sim/linear/sparse_lu.h"
#include "autodiff_sim/mesh/cloth_mesh.h"
#include "autodiff_sim/step/handle_constraints.h"

namespace clothfit {
namespace {

// Single precision times the matrices' condition, which is below 100.
constexpr double kFloatTolerance = 1e-5;

BlockPattern GridPattern(int n) {
  std::vector<std::vector<int>> cliques;
  for (int j = 0; j + 1 < n; ++j) {
    for (int i = 0; i + 1 < n; ++i) {
      const int a = i + j * n;
      cliques.push_back({a, a + 1, a + n, a + n + 1});
      if (i + 2 < n) cliques.push_back({a, a + 2});
    }
  }
  return MakePattern(n * n, cliques);
}

constexpr int kRow = BlockSparseMatrix::kRow;

// Diagonally dominant; `asymmetry` is the size of what has no mirror image.
BlockSparseMatrix RandomMatrix(const BlockPattern* pattern, double asymmetry, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  BlockSparseMatrix a(pattern);
  for (int row = 0; row < pattern->num_rows(); ++row) {
    for (int k = pattern->row_begin[row]; k < pattern->row_begin[row + 1]; ++k) {
      double* mirror = a.block(pattern->Find(pattern->column[k], row));
      for (int e = 0; e < 9; ++e) {
        const double value = uniform(random);
        a.block(k)[kRow * (e / 3) + e % 3] += value + asymmetry * uniform(random);
        mirror[kRow * (e % 3) + e / 3] += value;
      }
    }
    for (int p = 0; p < 3; ++p) a.block(pattern->diagonal[row])[(kRow + 1) * p] += 60.0;
  }
  return a;
}

Eigen::MatrixXd Dense(const BlockSparseMatrix& a) {
  const BlockPattern& pattern = a.pattern();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * pattern.num_rows(), 3 * pattern.num_rows());
  for (int row = 0; row < pattern.num_rows(); ++row) {
    for (int k = pattern.row_begin[row]; k < pattern.row_begin[row + 1]; ++k) {
      for (int e = 0; e < 9; ++e)
        dense(3 * row + e / 3, 3 * pattern.column[k] + e % 3) = a.block(k)[kRow * (e / 3) + e % 3];
    }
  }
  return dense;
}

Eigen::MatrixXd RandomColumns(Eigen::Index rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::MatrixXd x(rows, columns);
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] = uniform(random);
  return x;
}

// From a single panel to many, with heights that do and do not fill the registers.
class OnGrids : public testing::TestWithParam<int> {
 protected:
  const BlockPattern pattern_ = GridPattern(GetParam());
  const Eigen::Index size_ = 3 * pattern_.num_rows();
};
INSTANTIATE_TEST_SUITE_P(LinearAlgebra, OnGrids, testing::Values(2, 3, 5, 8, 13));

TEST_P(OnGrids, ProductsAreThoseOfTheDenseMatrix) {
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 1.0, 1);
  const Eigen::MatrixXd x = RandomColumns(size_, kLanes, 2), expected = Dense(a) * x;
  Lanes<kLanes> y = x;
  a.AddProduct<kLanes>(Lanes<kLanes>(x), -2.0, &y);
  EXPECT_LT((y - (x - 2.0 * expected)).norm(), 1e-13 * expected.norm());
  Lanes<1> y1 = x.col(0);
  a.AddProduct<1>(x.col(0), -2.0, &y1);
  EXPECT_LT((y1 - (x - 2.0 * expected).col(0)).norm(), 1e-13 * expected.norm());

  FloatBlockMatrix rounded(&pattern_);
  rounded.Round(a);
  FloatLanes<kLanes> z;
  rounded.Multiply<kLanes>(x.cast<float>(), &z);
  EXPECT_LT((z.cast<double>() - expected).norm(), kFloatTolerance * expected.norm());
  FloatLanes<1> z1;
  rounded.Multiply<1>(x.col(0).cast<float>(), &z1);
  EXPECT_LT((z1.cast<double>() - expected.col(0)).norm(), kFloatTolerance * expected.norm());
}

// Solves as this matrix would, as far as single precision goes.
void ExpectSolvesLike(const SupernodalFactor& factor, const Eigen::MatrixXd& matrix,
                      unsigned seed) {
  const Eigen::MatrixXd b = RandomColumns(matrix.rows(), kLanes, seed);
  const Eigen::MatrixXd expected = matrix.partialPivLu().solve(b);
  FloatLanes<kLanes> x;
  factor.Solve<kLanes>(b.cast<float>(), &x);
  EXPECT_LT((x.cast<double>() - expected).norm(), kFloatTolerance * expected.norm());
  FloatLanes<1> x1;
  factor.Solve<1>(b.col(3).cast<float>(), &x1);
  EXPECT_LT((x1.cast<double>() - expected.col(3)).norm(), kFloatTolerance * expected.norm());
}

TEST_P(OnGrids, TheFactorSolvesWithTheSymmetricPart) {
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 1.0, 3);
  const Eigen::MatrixXd dense = Dense(a), symmetric = 0.5 * (dense + dense.transpose());
  SparseCholesky factor(&pattern_);
  ASSERT_TRUE(factor.Factorize(a));
  EXPECT_EQ(factor.shift(), 0.0);
  EXPECT_EQ(factor.num_factorizations(), 1);
  ExpectSolvesLike(factor, symmetric, 4);
}

TEST_P(OnGrids, TheWholeFactorSolvesWithTheMatrixItself) {
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 4.0, 13);
  SparseLu factor(SparseCholesky(&pattern_).supernodes());
  ASSERT_TRUE(factor.Factorize(a));
  ExpectSolvesLike(factor, Dense(a), 14);
}

TEST_P(OnGrids, TheWholeFactorRefusesWhatWantsPivoting) {
  BlockSparseMatrix a = RandomMatrix(&pattern_, 1.0, 15);
  SparseLu factor(SparseCholesky(&pattern_).supernodes());
  ASSERT_TRUE(factor.Factorize(a));
  for (int k = 0; k < 3; ++k) a.block(pattern_.diagonal[0])[(kRow + 1) * k] = -5.0;
  EXPECT_FALSE(factor.Factorize(a));
  EXPECT_FALSE(factor.has_factor());
  a.block(0)[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factor.Factorize(a));
}

TEST_P(OnGrids, AnIndefiniteMatrixIsShiftedUntilItIsDefinite) {
  BlockSparseMatrix a = RandomMatrix(&pattern_, 0.0, 5);
  for (int k = 0; k < 3; ++k) a.block(pattern_.diagonal[0])[(kRow + 1) * k] = -5.0;
  SparseCholesky factor(&pattern_);
  ASSERT_TRUE(factor.Factorize(a));
  EXPECT_GT(factor.shift(), 0.0);
  const Eigen::MatrixXd shifted =
      Dense(a) + factor.shift() * Eigen::MatrixXd::Identity(size_, size_);
  const Eigen::VectorXd b = RandomColumns(size_, 1, 6), expected = shifted.llt().solve(b);
  FloatLanes<1> x;
  factor.Solve<1>(b.cast<float>(), &x);
  // The shift is up to four times too small to be far from singular.
  EXPECT_LT((shifted * x.cast<double>() - b).norm(), 1e-3 * b.norm());

  const int first = factor.num_factorizations();
  ASSERT_TRUE(factor.Factorize(a));  // begins near the shift it remembers
  EXPECT_LE(factor.num_factorizations() - first, 2);
}

TEST_P(OnGrids, WhatIsNoNumberIsRefused) {
  BlockSparseMatrix a = RandomMatrix(&pattern_, 0.0, 7);
  a.block(pattern_.num_blocks() - 1)[0] = std::numeric_limits<double>::quiet_NaN();
  SparseCholesky factor(&pattern_);
  EXPECT_FALSE(factor.Factorize(a));
  EXPECT_FALSE(factor.has_factor());
}

TEST_P(OnGrids, GmresSolvesWithAnotherMatrixThanItsFactor) {
  const BlockSparseMatrix before = RandomMatrix(&pattern_, 0.0, 8);
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 4.0, 9);
  SparseCholesky factor(&pattern_);
  ASSERT_TRUE(factor.Factorize(before));
  Gmres gmres(&pattern_);
  gmres.SetMatrix(&a);
  Eigen::MatrixXd b = RandomColumns(size_, kLanes, 10);
  b.col(1) *= 1e-30;  // tolerances are relative, column by column
  b.col(2).setZero();
  const Eigen::MatrixXd expected = Dense(a).partialPivLu().solve(b);
  GmresOptions options;
  for (const double tolerance : {1e-3, 1e-8, 1e-12}) {
    options.relative_tolerance = tolerance;
    options.max_iterations = 200;
    Lanes<kLanes> x = RandomColumns(size_, kLanes, 11);
    const GmresReport report = gmres.Solve<kLanes>(&factor, b, options, &x);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.relative_residual, tolerance);
    for (int c = 0; c < kLanes; ++c) {
      // The residual is one of the preconditioned system, whose condition is about 10.
      EXPECT_LE((x - expected).col(c).norm(), 10.0 * tolerance * expected.col(c).norm()) << c;
    }
    Lanes<1> x1 = Lanes<1>::Zero(size_);
    EXPECT_TRUE(gmres.Solve<1>(&factor, b.col(0), options, &x1).converged);
    EXPECT_LE((x1 - expected.col(0)).norm(), 10.0 * tolerance * expected.col(0).norm());
  }
  for (const double rough : {0.05, 0.3, 0.9}) {  // as of a first Newton direction
    options.relative_tolerance = rough;
    Lanes<1> x = Lanes<1>::Zero(size_);
    EXPECT_TRUE(gmres.Solve<1>(&factor, b.col(0), options, &x).converged);
    EXPECT_LE((x - expected.col(0)).norm(), 10.0 * rough * expected.col(0).norm());
  }
  options.max_iterations = 1;
  options.relative_tolerance = 1e-12;
  Lanes<kLanes> x = Lanes<kLanes>::Zero(size_, kLanes);
  EXPECT_FALSE(gmres.Solve<kLanes>(&factor, b, options, &x).converged);
}

// With the factor of the matrix itself a few refinements do; with one that only claims to be that,
// the result is none the worse.
TEST_P(OnGrids, RefinementSolvesAsFarAsItsFactorAllows) {
  const BlockSparseMatrix before = RandomMatrix(&pattern_, 0.0, 16);
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 4.0, 17);
  SparseLu exact(SparseCholesky(&pattern_).supernodes()), other = exact;
  ASSERT_TRUE(exact.Factorize(a));
  ASSERT_TRUE(other.Factorize(before));
  Gmres gmres(&pattern_);
  gmres.SetMatrix(&a);
  Eigen::MatrixXd b = RandomColumns(size_, kLanes, 18);
  b.col(1) *= 1e-30;
  b.col(2).setZero();
  const Eigen::MatrixXd expected = Dense(a).partialPivLu().solve(b);
  GmresOptions options;
  options.factor_is_exact = true;
  options.max_iterations = 200;
  for (const double tolerance : {1e-3, 1e-8, 1e-12}) {
    options.relative_tolerance = tolerance;
    for (const SparseLu* factor : {&exact, &other}) {
      Lanes<kLanes> x = RandomColumns(size_, kLanes, 19);
      const GmresReport report = gmres.Solve<kLanes>(factor, b, options, &x);
      EXPECT_TRUE(report.converged);
      if (factor == &exact) {  // from a guess 1e30 times too large
        EXPECT_LE(report.iterations, 12);
      }
      for (int c = 0; c < kLanes; ++c) {
        EXPECT_LE((x - expected).col(c).norm(), 10.0 * tolerance * expected.col(c).norm()) << c;
      }
    }
  }
  Lanes<kLanes> x = expected;
  options.relative_tolerance = 1e-10;
  EXPECT_EQ(gmres.Solve<kLanes>(&exact, b, options, &x).iterations, 1);
}

// Derivatives of a motion that has gone astray grow until their squares are no numbers any more,
// and shrink until they are zero: a search that neither ends nor gets anywhere hangs.
TEST_P(OnGrids, GmresEndsWhateverTheSizeOfItsSolution) {
  const BlockSparseMatrix before = RandomMatrix(&pattern_, 0.0, 8);
  const BlockSparseMatrix a = RandomMatrix(&pattern_, 4.0, 9);
  SparseCholesky factor(&pattern_);
  ASSERT_TRUE(factor.Factorize(before));
  SparseLu exact(factor.supernodes());
  ASSERT_TRUE(exact.Factorize(a));
  Gmres gmres(&pattern_);
  gmres.SetMatrix(&a);
  const Eigen::MatrixXd b = RandomColumns(size_, kLanes, 10);
  const Eigen::MatrixXd expected = Dense(a).partialPivLu().solve(b);
  const Eigen::MatrixXd off = RandomColumns(size_, kLanes, 11);
  for (const SupernodalFactor* used :
       {static_cast<SupernodalFactor*>(&factor), static_cast<SupernodalFactor*>(&exact)}) {
    for (const double size : {1e-290, 1e-170, 1e-150, 1.0, 1e150, 1e157, 1e170, 1e300}) {
      for (const double start : {0.0, 1e-12, 1e-9, 1e-3}) {
        GmresOptions options;
        options.relative_tolerance = 1e-9;
        options.factor_is_exact = used == &exact;
        const double guess = start > 0.0 ? 1.0 : 0.0;
        Lanes<kLanes> x = size * (guess * expected + start * off);
        const Lanes<kLanes> rhs = size * b;
        EXPECT_TRUE(gmres.Solve<kLanes>(used, rhs, options, &x).converged) << size << " " << start;
        EXPECT_LE((x / size - expected).norm(), 1e-7 * expected.norm()) << size << " " << start;
      }
    }
  }
}

// METIS draws random numbers that all threads share: rounding, and with it where a chaotic fit
// ends, depended on what other threads did.
TEST(Supernodes, AreTheSameWhateverOtherThreadsFind) {
  const BlockPattern pattern = GridPattern(24);
  const std::vector<int> alone = FindSupernodes(pattern).order;
  std::atomic<int> count_other = 0;
  ParallelFor(200, 4,
              [&](int, int) { count_other += FindSupernodes(pattern).order == alone ? 0 : 1; });
  EXPECT_EQ(count_other, 0);
}

TEST(HandleReduction, IsTheProductWithTheSubstitutionsMatrix) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {6, 6});
  // A particle, a point on an edge, a point inside a triangle.
  const std::vector<SurfacePoint> points =
      LocateOnCloth(mesh, {{0.0, 0.0}, {1.0, 0.5}, {0.47, 0.88}});
  std::vector<HandleTarget> handles;
  for (const SurfacePoint& point : points) handles.push_back({point, Eigen::Vector3d::Zero()});
  const HandleConstraints constraints(handles);
  std::vector<std::vector<int>> cliques(mesh.triangles.size());
  for (std::size_t t = 0; t < cliques.size(); ++t)
    cliques[t].assign(mesh.triangles[t].begin(), mesh.triangles[t].end());
  const BlockPattern bare = MakePattern(36, cliques);
  for (const std::vector<int>& clique : constraints.ExtraCliques(bare)) cliques.push_back(clique);
  const BlockPattern pattern = MakePattern(36, cliques);
  BlockSparseMatrix a = RandomMatrix(&pattern, 1.0, 12);
  const Eigen::MatrixXd before = Dense(a);

  Eigen::MatrixXd t = Eigen::MatrixXd::Identity(108, 108);  // dv = T (free part of dv)
  for (int column = 0; column < 108; ++column) {
    Lanes<1> unit = t.col(column);
    constraints.ExpandDirection<1>(&unit);
    t.col(column) = unit;
  }
  constraints.ReduceMatrix(&a);
  const Eigen::MatrixXd expected = t.transpose() * before * t, reduced = Dense(a);
  int held = 0;
  for (int row = 0; row < 108; ++row) {
    const bool row_held = t.col(row).isZero(0.0);
    held += row_held;
    for (int column = 0; column < 108; ++column) {
      if (row_held || t.col(column).isZero(0.0)) {
        EXPECT_EQ(reduced(row, column) != 0.0, row == column);
      } else {
        EXPECT_NEAR(reduced(row, column), expected(row, column), 1e-11);
      }
    }
  }
  EXPECT_EQ(held, 9);
  const Eigen::VectorXd r = RandomColumns(108, 1, 13);
  Lanes<1> reduced_r = r;
  constraints.ReduceResidual<1>(&reduced_r);
  EXPECT_LT((reduced_r - t.transpose() * r).norm(), 1e-13);
}

// A function that uses every operation.
template <class T>
T Everything(const T& x, const T& y) {
  T sum = x * y + x / y - (x - 2.0) * (3.0 - y) + (1.5 + x) / 2.0 + 2.0 / y - (-x) * 4.0 + y * 0.5;
  sum += sqrt(x * x + y * y) + exp(x * 0.1) + log(y) + sin(x) * cos(y) + tan(x * 0.2);
  sum -= asin(x * 0.1) + acos(y * 0.1) + atan(x) + atan2(x, y) + tanh(x - y) + abs(x - y * 3.0);
  sum *= pow(y, 1.5) + pow(y, x) + (x + 1.0) * (2.0 + y) - (y - x);
  sum /= x + 3.0;
  sum += 2.0;
  sum -= 1.0;
  sum *= 3.0;
  sum /= 7.0;
  return x < y ? sum : -sum;
}

TEST(DualNumbers, AgreeWithJets) {
  using Jet = ceres::Jet<double, 16>;
  int checked = 0;
  for (const double at : {0.3, 0.9, 1.7}) {
    Jet x(at), y(1.2);
    Dual<16> dual_x(at), dual_y(1.2);
    for (int i = 0; i < 16; ++i) {
      x.v[i] = std::sin(i + 1.0), y.v[i] = std::cos(3.0 * i);
      dual_x.SetDerivative(i, x.v[i]), dual_y.SetDerivative(i, y.v[i]);
    }
    const Jet expected = Everything(x, y);
    const Dual<16> got = Everything(dual_x, dual_y);
    EXPECT_NEAR(got.a, expected.a, 1e-13 * std::abs(expected.a));
    for (int i = 0; i < 16; ++i) {
      EXPECT_NEAR(got.derivative(i), expected.v[i], 1e-12 * expected.v.norm());
      ++checked;
    }
  }
  EXPECT_EQ(checked, 48);
}

}  // namespace
}  // namespace clothfit
