// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A number with kSize first derivatives: ceres::Jet's arithmetic on whole vector registers, which
// the compiler keeps in registers where it spills a Jet's matrix after every operation. The types
// are GCC's and Clang's. The batches evaluate terms with it; tests compare it with ceres::Jet.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "autodiff_sim/base/vector_width.h"

namespace clothfit {

typedef double DualRegister __attribute__((vector_size(kVectorBytes), may_alias));

// The least number of derivatives that fills whole registers and holds so many.
constexpr int WholeRegisters(int derivatives) {
  constexpr int kWidth = kVectorBytes / static_cast<int>(sizeof(double));
  return (derivatives + kWidth - 1) / kWidth * kWidth;
}

template <int kSize>
struct Dual {
  static constexpr int kWidth = kVectorBytes / static_cast<int>(sizeof(double));
  static_assert(kSize % kWidth == 0, "derivatives fill whole registers");
  static constexpr int kRegisters = kSize / kWidth;

  double a = 0.0;
  DualRegister v[kRegisters] = {};

  Dual() = default;
  explicit Dual(double value) : a(value) {}
  // Member by member: the compiler's own would copy the padding too, whole registers at a time, and
  // wait for `a` to reach the cache.
  Dual(const Dual& other) : a(other.a) {
    for (int i = 0; i < kRegisters; ++i) v[i] = other.v[i];
  }
  Dual& operator=(const Dual& other) {
    a = other.a;
    for (int i = 0; i < kRegisters; ++i) v[i] = other.v[i];
    return *this;
  }

  double derivative(int i) const { return v[i / kWidth][i % kWidth]; }
  void SetDerivative(int i, double value) { v[i / kWidth][i % kWidth] = value; }

  Dual& operator+=(const Dual& g) { return *this = *this + g; }
  Dual& operator-=(const Dual& g) { return *this = *this - g; }
  Dual& operator*=(const Dual& g) { return *this = *this * g; }
  Dual& operator/=(const Dual& g) { return *this = *this / g; }
  Dual& operator+=(double s) { return *this = *this + s; }
  Dual& operator-=(double s) { return *this = *this - s; }
  Dual& operator*=(double s) { return *this = *this * s; }
  Dual& operator/=(double s) { return *this = *this / s; }

  // The function with this value and this slope at f, and with two slopes at f and g.
  static Dual Chain(double value, double slope, const Dual& f) {
    Dual out(value);
    for (int i = 0; i < kRegisters; ++i) out.v[i] = slope * f.v[i];
    return out;
  }
  static Dual Chain(double value, double slope_f, const Dual& f, double slope_g, const Dual& g) {
    Dual out(value);
    for (int i = 0; i < kRegisters; ++i) out.v[i] = slope_f * f.v[i] + slope_g * g.v[i];
    return out;
  }

  friend Dual operator+(const Dual& f) { return f; }
  friend Dual operator-(const Dual& f) { return Chain(-f.a, -1.0, f); }
  friend Dual operator+(const Dual& f, const Dual& g) {
    Dual out(f.a + g.a);
    for (int i = 0; i < kRegisters; ++i) out.v[i] = f.v[i] + g.v[i];
    return out;
  }
  friend Dual operator-(const Dual& f, const Dual& g) {
    Dual out(f.a - g.a);
    for (int i = 0; i < kRegisters; ++i) out.v[i] = f.v[i] - g.v[i];
    return out;
  }
  friend Dual operator*(const Dual& f, const Dual& g) { return Chain(f.a * g.a, g.a, f, f.a, g); }
  friend Dual operator/(const Dual& f, const Dual& g) {
    const double inverse = 1.0 / g.a, value = f.a * inverse;
    return Chain(value, inverse, f, -value * inverse, g);
  }
  friend Dual operator+(Dual f, double s) { return f.a += s, f; }
  friend Dual operator+(double s, Dual f) { return f.a += s, f; }
  friend Dual operator-(Dual f, double s) { return f.a -= s, f; }
  friend Dual operator-(double s, const Dual& f) { return Chain(s - f.a, -1.0, f); }
  friend Dual operator*(const Dual& f, double s) { return Chain(f.a * s, s, f); }
  friend Dual operator*(double s, const Dual& f) { return Chain(f.a * s, s, f); }
  friend Dual operator/(const Dual& f, double s) { return f * (1.0 / s); }
  friend Dual operator/(double s, const Dual& f) {
    const double value = s / f.a;
    return Chain(value, -value / f.a, f);
  }

  friend bool operator<(const Dual& f, const Dual& g) { return f.a < g.a; }
  friend bool operator>(const Dual& f, const Dual& g) { return f.a > g.a; }
  friend bool operator<=(const Dual& f, const Dual& g) { return f.a <= g.a; }
  friend bool operator>=(const Dual& f, const Dual& g) { return f.a >= g.a; }
  friend bool operator<(const Dual& f, double s) { return f.a < s; }
  friend bool operator>(const Dual& f, double s) { return f.a > s; }
  friend bool operator<=(const Dual& f, double s) { return f.a <= s; }
  friend bool operator>=(const Dual& f, double s) { return f.a >= s; }

  friend Dual abs(const Dual& f) { return f.a < 0.0 ? -f : f; }
  friend Dual sqrt(const Dual& f) {
    const double root = std::sqrt(f.a);
    return Chain(root, 0.5 / root, f);
  }
  friend Dual exp(const Dual& f) {
    const double value = std::exp(f.a);
    return Chain(value, value, f);
  }
  friend Dual log(const Dual& f) { return Chain(std::log(f.a), 1.0 / f.a, f); }
  friend Dual sin(const Dual& f) { return Chain(std::sin(f.a), std::cos(f.a), f); }
  friend Dual cos(const Dual& f) { return Chain(std::cos(f.a), -std::sin(f.a), f); }
  friend Dual tan(const Dual& f) {
    const double value = std::tan(f.a);
    return Chain(value, 1.0 + value * value, f);
  }
  friend Dual asin(const Dual& f) {
    return Chain(std::asin(f.a), 1.0 / std::sqrt(1.0 - f.a * f.a), f);
  }
  friend Dual acos(const Dual& f) {
    return Chain(std::acos(f.a), -1.0 / std::sqrt(1.0 - f.a * f.a), f);
  }
  friend Dual atan(const Dual& f) { return Chain(std::atan(f.a), 1.0 / (1.0 + f.a * f.a), f); }
  friend Dual atan2(const Dual& g, const Dual& f) {
    const double inverse = 1.0 / (f.a * f.a + g.a * g.a);
    return Chain(std::atan2(g.a, f.a), f.a * inverse, g, -g.a * inverse, f);
  }
  friend Dual tanh(const Dual& f) {
    const double value = std::tanh(f.a);
    return Chain(value, 1.0 - value * value, f);
  }
  friend Dual pow(const Dual& f, double exponent) {
    return Chain(std::pow(f.a, exponent), exponent * std::pow(f.a, exponent - 1.0), f);
  }
  friend Dual pow(const Dual& f, const Dual& g) {
    const double value = std::pow(f.a, g.a);
    return Chain(value, g.a * std::pow(f.a, g.a - 1.0), f, value * std::log(f.a), g);
  }
};

template <int kSize>
double Value(const Dual<kSize>& value) {
  return value.a;
}

}  // namespace clothfit

namespace Eigen {

template <int kSize>
struct NumTraits<clothfit::Dual<kSize>> : GenericNumTraits<double> {
  using Real = clothfit::Dual<kSize>;
  using NonInteger = clothfit::Dual<kSize>;
  using Nested = clothfit::Dual<kSize>;
  using Literal = clothfit::Dual<kSize>;
  enum { RequireInitialization = 1, ReadCost = 1, AddCost = 1, MulCost = 3 };
};

template <class BinaryOp, int kSize>
struct ScalarBinaryOpTraits<clothfit::Dual<kSize>, double, BinaryOp> {
  using ReturnType = clothfit::Dual<kSize>;
};
template <class BinaryOp, int kSize>
struct ScalarBinaryOpTraits<double, clothfit::Dual<kSize>, BinaryOp> {
  using ReturnType = clothfit::Dual<kSize>;
};

}  // namespace Eigen
