// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// GMRES (Saad and Schultz 1986) with Givens rotations, one Hessenberg matrix a column.
#include "autodiff_sim/linear/gmres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "autodiff_sim/base/flush_denormals.h"

namespace clothfit {
namespace {

// A cycle ends when single precision has no more to give, or when its basis outgrows the cache.
constexpr double kCycleReduction = 1e-4;
constexpr int kLongestCycle = 30;

template <int kColumns>
using Row = Eigen::Array<double, 1, kColumns>;
template <int kColumns>
using FloatRow = Eigen::Array<float, 1, kColumns>;

template <int kColumns>
Row<kColumns> Dots(const FloatLanes<kColumns>& a, const FloatLanes<kColumns>& b) {
  if constexpr (kColumns == 1) {
    return Row<1>(static_cast<double>(a.dot(b)));
  } else {
    using Part = Eigen::Matrix<float, 1, kColumns>;
    Part sum0 = Part::Zero(), sum1 = sum0, sum2 = sum0;
    for (Eigen::Index i = 0; i < a.rows(); i += 3) {  // rows come in threes
      sum0 += a.row(i).cwiseProduct(b.row(i));
      sum1 += a.row(i + 1).cwiseProduct(b.row(i + 1));
      sum2 += a.row(i + 2).cwiseProduct(b.row(i + 2));
    }
    return (sum0 + sum1 + sum2).template cast<double>().array();
  }
}

// y += x scaled column by column.
template <int kColumns>
void AddScaled(const FloatLanes<kColumns>& x, const Row<kColumns>& scale, FloatLanes<kColumns>* y) {
  const Eigen::Matrix<float, 1, kColumns> factor = scale.template cast<float>().matrix();
  for (Eigen::Index i = 0; i < x.rows(); ++i) y->row(i) += x.row(i).cwiseProduct(factor);
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

template <int kColumns>
Row<kColumns> Norms(const FloatLanes<kColumns>& a) {
  return Dots<kColumns>(a, a).sqrt();
}

// x += d, in units of scale.
template <int kColumns>
void AddTo(const FloatLanes<kColumns>& d, const Row<kColumns>& scale, Lanes<kColumns>* x) {
  const Eigen::Matrix<double, 1, kColumns> factor = scale.matrix();
  for (Eigen::Index i = 0; i < d.rows(); ++i) {
    x->row(i) += d.row(i).template cast<double>().cwiseProduct(factor);
  }
}

// |x + z|, z in units of scale: about the size of the solution.
template <int kColumns>
Row<kColumns> SizeWith(const Lanes<kColumns>& x, const FloatLanes<kColumns>& z,
                       const Row<kColumns>& scale) {
  const Eigen::Matrix<double, 1, kColumns> factor = scale.matrix();
  const Eigen::Matrix<double, 1, kColumns> inverse = scale.inverse().matrix();
  Row<kColumns> sum = Row<kColumns>::Zero();
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    sum += (x.row(i).cwiseProduct(inverse) + z.row(i).template cast<double>()).array().square();
  }
  return sum.sqrt() * factor.array();
}

// One cycle for P^-1 A d = z, down to the norms in `target`. Adds d to x and returns the norms of
// the residuals.
template <int kColumns>
Row<kColumns> Cycle(const FloatBlockMatrix& a, const SupernodalFactor* preconditioner,
                    FloatLanes<kColumns> z, const Row<kColumns>& norm, const Row<kColumns>& target,
                    const Row<kColumns>& scale, int max_iterations, int* iterations,
                    Lanes<kColumns>* x) {
  HessenbergProblem<kColumns> problem(norm);
  std::vector<FloatLanes<kColumns>> basis;
  FloatLanes<kColumns> product;
  Row<kColumns> residual = norm, length = norm;
  while ((residual > target).any() && static_cast<int>(basis.size()) < max_iterations) {
    const Eigen::Matrix<float, 1, kColumns> inverse =
        (length > 0.0).select(1.0 / length, 0.0).template cast<float>().matrix();
    for (Eigen::Index i = 0; i < z.rows(); ++i) z.row(i) = z.row(i).cwiseProduct(inverse);
    basis.push_back(z);
    a.Multiply<kColumns>(basis.back(), &product);
    preconditioner->Solve<kColumns>(product, &z);
    // P^-1 A is near the identity; without it nothing cancels in what is made orthogonal.
    z -= basis.back();
    std::vector<Row<kColumns>> h;
    for (const FloatLanes<kColumns>& v : basis) {  // modified Gram-Schmidt
      h.push_back(Dots<kColumns>(v, z));
      AddScaled<kColumns>(v, -h.back(), &z);
    }
    h.back() += 1.0;
    length = Norms<kColumns>(z);
    h.push_back(length);
    residual = problem.Append(std::move(h));
    if (!residual.allFinite()) return residual;
    ++*iterations;
  }
  const std::vector<Row<kColumns>> y = problem.Solve();
  FloatLanes<kColumns> d = FloatLanes<kColumns>::Zero(z.rows(), kColumns);
  for (std::size_t k = 0; k < basis.size(); ++k) AddScaled<kColumns>(basis[k], y[k], &d);
  AddTo<kColumns>(d, scale, x);
  return residual;
}

// |x|, whatever its size: the squares of what is very large or small are no numbers.
template <int kColumns>
Row<kColumns> Sizes(const Lanes<kColumns>& x) {
  const Row<kColumns> largest = x.cwiseAbs().colwise().maxCoeff().array();
  const Row<kColumns> scale = (largest > 0.0).select(largest, 1.0);
  return SizeWith<kColumns>(x, FloatLanes<kColumns>::Zero(x.rows(), kColumns), scale);
}

template <int kColumns>
Row<kColumns> Relative(const Row<kColumns>& error, const Row<kColumns>& size) {
  return error / (size > 0.0).select(size, 1.0);
}

// Whether to add P^-1 (b - A x) to x as it is, time after time: with an exact factor, as long as
// each takes most of the error that the one before has left.
template <int kColumns>
class Refinement {
 public:
  explicit Refinement(const GmresOptions& options)
      : serves_(options.factor_is_exact), tolerance_(options.relative_tolerance) {}

  // error: what is to be added now, size: of the solution. `relative` becomes what is left then.
  bool Serves(const Row<kColumns>& error, const Row<kColumns>& size, Row<kColumns>* relative) {
    if (!serves_) return false;
    const Row<kColumns> contraction =
        (before_ > 0.0).select(error / before_.max(kTiny), 1.0).min(1.0);
    *relative = Relative<kColumns>(error * contraction, size);
    serves_ = is_first_ || (*relative <= tolerance_ || contraction <= kRefines).all();
    is_first_ = false;
    before_ = error;
    return serves_;
  }

 private:
  static constexpr double kRefines = 0.1;
  static constexpr double kTiny = std::numeric_limits<double>::min();

  bool serves_, is_first_ = true;
  double tolerance_;
  Row<kColumns> before_ = Row<kColumns>::Zero();
};

}  // namespace

template <int kColumns>
Preconditioned<kColumns>::Preconditioned(const SupernodalFactor& factor, const Lanes<kColumns>& r) {
  const Row<kColumns> largest = r.cwiseAbs().colwise().maxCoeff().array();
  scale = (largest > 0.0).select(largest, 1.0);
  const Eigen::Matrix<double, 1, kColumns> inverse = (1.0 / scale).matrix();
  FloatLanes<kColumns> rounded(r.rows(), kColumns);
  for (Eigen::Index i = 0; i < r.rows(); ++i) {
    rounded.row(i) = r.row(i).cwiseProduct(inverse).template cast<float>();
  }
  factor.Solve<kColumns>(rounded, &z);
}

template <int kColumns>
GmresReport Gmres::Solve(const SupernodalFactor* preconditioner, const Lanes<kColumns>& b,
                         const GmresOptions& options, Lanes<kColumns>* x,
                         const Preconditioned<kColumns>* first) const {
  const FlushDenormals flush;
  GmresReport report;
  for (int c = 0; c < kColumns; ++c) {
    if (b.col(c).isZero(0.0)) x->col(c).setZero();
  }
  bool is_fresh = x->isZero(0.0);
  Refinement<kColumns> refinement(options);
  while (report.iterations <= options.max_iterations && !report.converged) {
    Preconditioned<kColumns> left;  // P^-1 (b - A x)
    if (is_fresh) {
      left = first != nullptr ? *first : Preconditioned<kColumns>(*preconditioner, b);
    } else {
      Lanes<kColumns> r = b;
      matrix_->AddProduct<kColumns>(*x, -1.0, &r);
      left = Preconditioned<kColumns>(*preconditioner, r);
    }
    is_fresh = false;
    FloatLanes<kColumns>& z = left.z;
    const Row<kColumns> scale = left.scale;
    Row<kColumns> relative;
    const Row<kColumns> norm = Norms<kColumns>(z);
    const Row<kColumns> size = SizeWith<kColumns>(*x, z, scale);
    if (!norm.allFinite() || !size.allFinite()) return report;
    if (refinement.Serves(norm * scale, size, &relative)) {
      AddTo<kColumns>(z, scale, x);
      ++report.iterations;
    } else if (relative = Relative<kColumns>(norm * scale, size);
               (relative > options.relative_tolerance).any()) {
      // Only then: a cycle for what is good enough would end before it began, time after time.
      const Row<kColumns> wanted =
          (options.relative_tolerance * size / scale).max(kCycleReduction * norm);
      const int patience = std::min(kLongestCycle, options.max_iterations - report.iterations);
      if (patience <= 0) return report;
      const Row<kColumns> residual =
          Cycle<kColumns>(rounded_, preconditioner, std::move(z), norm, wanted, scale, patience,
                          &report.iterations, x);
      if (!residual.allFinite()) return report;
      // Of what was reached, as a guess may have been far too large; at least |x + P^-1 r|.
      const Row<kColumns> error = residual * scale;
      relative = Relative<kColumns>(error, Sizes<kColumns>(*x) + error);
    }
    report.relative_residual = relative.maxCoeff();
    report.converged = (relative <= options.relative_tolerance).all();
  }
  return report;
}

template struct Preconditioned<1>;
template GmresReport Gmres::Solve<1>(const SupernodalFactor*, const Lanes<1>&, const GmresOptions&,
                                     Lanes<1>*, const Preconditioned<1>*) const;
template GmresReport Gmres::Solve<kLanes>(const SupernodalFactor*, const Lanes<kLanes>&,
                                          const GmresOptions&, Lanes<kLanes>*,
                                          const Preconditioned<kLanes>*) const;

}  // namespace clothfit
