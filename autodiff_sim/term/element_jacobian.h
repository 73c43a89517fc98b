// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of an element's forces by its own particles, for terms that write them down
// themselves. Every term has them by automatic differentiation; the few on which most of a step's
// time would go then have them in closed form too, as a static member
//   template <class Sink>
//   static void AddJacobian(const Element&, const ElementInput<Term, double>&,
//                           const JacobianWeights&, const Sink& sink);
// that calls sink(a, b, p, row): row is of component p of the force on node a, by the place and
// velocity of node b, weighted and added up.
#pragma once

#include <type_traits>

#include <Eigen/Core>

#include "autodiff_sim/base/vector_width.h"

namespace clothfit {

// What the derivatives by positions, velocities and accelerations count.
struct JacobianWeights {
  double x, v, a;
};

// Three numbers, filled up with a zero: one vector register, or two small ones.
class JacobianRow {
 public:
  JacobianRow() = default;
  JacobianRow(double a, double b, double c) {
    part_[0][0] = a;
    part_[0][1] = b;
    part_[2 / kWidth][2 % kWidth] = c;
  }
  explicit JacobianRow(const Eigen::Vector3d& p) : JacobianRow(p[0], p[1], p[2]) {}

  JacobianRow& operator+=(const JacobianRow& other) {
    for (int i = 0; i < kParts; ++i) part_[i] += other.part_[i];
    return *this;
  }
  JacobianRow& operator-=(const JacobianRow& other) {
    for (int i = 0; i < kParts; ++i) part_[i] -= other.part_[i];
    return *this;
  }
  friend JacobianRow operator+(JacobianRow a, const JacobianRow& b) { return a += b; }
  friend JacobianRow operator-(JacobianRow a, const JacobianRow& b) { return a -= b; }
  friend JacobianRow operator-(const JacobianRow& a) { return JacobianRow() - a; }
  friend JacobianRow operator*(double scale, JacobianRow a) {
    for (int i = 0; i < kParts; ++i) a.part_[i] *= scale;
    return a;
  }

  // target: 4 numbers, 32 bytes aligned.
  void AddTo(double* target) const {
    Part* parts = reinterpret_cast<Part*>(target);
    for (int i = 0; i < kParts; ++i) parts[i] += part_[i];
  }

 private:
  static constexpr int kBytes = 4 * sizeof(double);
  static constexpr int kPartBytes = kVectorBytes < kBytes ? kVectorBytes : kBytes;
  static constexpr int kParts = kBytes / kPartBytes;
  static constexpr int kWidth = kPartBytes / static_cast<int>(sizeof(double));
  typedef double Part __attribute__((vector_size(kPartBytes), may_alias));
  Part part_[kParts] = {};
};

// Whether a term writes down its derivatives.
struct NoSink {
  void operator()(int, int, int, const JacobianRow&) const {}
};
template <class Term, class = void>
constexpr bool kWritesJacobian = false;
template <class Term>
constexpr bool kWritesJacobian<Term, std::void_t<decltype(Term::template AddJacobian<NoSink>)>> =
    true;

// The derivatives of two nodes that push each other apart with opposite forces: row of component p
// of the force on node a, by the place of node b relative to that of a.
template <class Sink>
void AddPairRow(int a, int b, int p, const JacobianRow& row, const Sink& sink) {
  sink(a, b, p, row);
  sink(a, a, p, -row);
  sink(b, a, p, row);
  sink(b, b, p, -row);
}

}  // namespace clothfit
