// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// GMRES (Saad and Schultz 1986) with Givens rotations, one Hessenberg matrix a column.
#include "autodiff_sim/gmres.h"

#include <cmath>
#include <vector>

namespace clothfit {
namespace {

template <int kColumns>
using Row = Eigen::Array<double, 1, kColumns>;

template <int kColumns>
Row<kColumns> ColumnDots(const Lanes<kColumns>& a, const Lanes<kColumns>& b) {
  return a.cwiseProduct(b).colwise().sum().array();
}

// The small least-squares problem of every column, updated as the Krylov spaces grow.
template <int kColumns>
class HessenbergProblem {
 public:
  explicit HessenbergProblem(const Row<kColumns>& norm) { rhs_.push_back(norm); }

  // Takes column k of the Hessenberg matrix, k + 2 entries; returns the residuals' norms.
  Row<kColumns> Append(std::vector<Row<kColumns>> h) {
    const std::size_t k = columns_.size();
    for (std::size_t i = 0; i < k; ++i) {
      const Row<kColumns> rotated = cosine_[i] * h[i] + sine_[i] * h[i + 1];
      h[i + 1] = cosine_[i] * h[i + 1] - sine_[i] * h[i];
      h[i] = rotated;
    }
    const Row<kColumns> length = (h[k].square() + h[k + 1].square()).sqrt();
    const auto usable = (length > 0.0);
    cosine_.push_back(usable.select(h[k] / length, 1.0));
    sine_.push_back(usable.select(h[k + 1] / length, 0.0));
    h[k] = usable.select(length, 1.0);
    columns_.push_back(std::move(h));
    rhs_.push_back(-sine_[k] * rhs_[k]);
    rhs_[k] *= cosine_[k];
    return rhs_[k + 1].abs();
  }

  std::vector<Row<kColumns>> Solve() const {
    const int n = static_cast<int>(columns_.size());
    std::vector<Row<kColumns>> y(n);
    for (int i = n - 1; i >= 0; --i) {
      Row<kColumns> sum = rhs_[i];
      for (int j = i + 1; j < n; ++j) sum -= columns_[j][i] * y[j];
      y[i] = sum / columns_[i][i];
    }
    return y;
  }

 private:
  std::vector<std::vector<Row<kColumns>>> columns_;
  std::vector<Row<kColumns>> cosine_, sine_, rhs_;
};

}  // namespace

template <int kColumns>
GmresReport SolveGmres(const BlockSparseMatrix& a, SparseCholesky* preconditioner,
                       const Lanes<kColumns>& b, const GmresOptions& options, Lanes<kColumns>* x) {
  GmresReport report;
  const Eigen::Index n = b.rows();
  Lanes<kColumns> w(n, kColumns), scratch(n, kColumns);
  preconditioner->Solve<kColumns>(b, &w);
  const Row<kColumns> target = ColumnDots<kColumns>(w, w).sqrt();
  const Row<kColumns> scale = (target > 0.0).select(target, 1.0);
  for (int c = 0; c < kColumns; ++c) {
    if (target[c] == 0.0) x->col(c).setZero();
  }
  if (!target.allFinite()) return report;
  if (!x->isZero(0.0)) {  // w = P^-1 (b - A x)
    scratch = b;
    a.AddProduct<kColumns>(*x, -1.0, &scratch);
    preconditioner->Solve<kColumns>(scratch, &w);
  }
  Row<kColumns> norm = ColumnDots<kColumns>(w, w).sqrt();
  report.relative_residual = (norm / scale).maxCoeff();
  std::vector<Lanes<kColumns>> basis;
  HessenbergProblem<kColumns> problem(norm);
  const auto normalised = [](const Lanes<kColumns>& v, const Row<kColumns>& length) {
    const Row<kColumns> inverse = (length > 0.0).select(1.0 / length, 0.0);
    return Lanes<kColumns>((v.array().rowwise() * inverse).matrix());
  };
  while (report.relative_residual > options.relative_tolerance &&
         report.iterations < options.max_iterations) {
    basis.push_back(normalised(w, norm));
    scratch.setZero();
    a.AddProduct<kColumns>(basis.back(), 1.0, &scratch);
    preconditioner->Solve<kColumns>(scratch, &w);
    std::vector<Row<kColumns>> h;
    for (const Lanes<kColumns>& v : basis) {  // modified Gram-Schmidt
      h.push_back(ColumnDots<kColumns>(v, w));
      w.array() -= v.array().rowwise() * h.back();
    }
    norm = ColumnDots<kColumns>(w, w).sqrt();
    h.push_back(norm);
    const Row<kColumns> residual = problem.Append(std::move(h));
    if (!residual.allFinite()) return report;
    report.relative_residual = (residual / scale).maxCoeff();
    ++report.iterations;
  }
  const std::vector<Row<kColumns>> y = problem.Solve();
  for (std::size_t k = 0; k < basis.size(); ++k) x->array() += basis[k].array().rowwise() * y[k];
  report.converged = report.relative_residual <= options.relative_tolerance;
  return report;
}

template GmresReport SolveGmres<1>(const BlockSparseMatrix&, SparseCholesky*, const Lanes<1>&,
                                   const GmresOptions&, Lanes<1>*);
template GmresReport SolveGmres<kLanes>(const BlockSparseMatrix&, SparseCholesky*,
                                        const Lanes<kLanes>&, const GmresOptions&, Lanes<kLanes>*);

}  // namespace clothfit
