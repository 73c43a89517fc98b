// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A number with its derivatives along N directions: what a force term of one's own is evaluated
// with, so that its force is written once.
#pragma once

#include <array>
#include <cmath>

namespace clothfit::v0 {

template <int N>
struct Dual {
  double value = 0.0;
  std::array<double, N> derivative = {};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT(google-explicit-constructor): a number is one

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  // A function of two numbers with this value and these partial derivatives.
  static Dual Of(double v, const Dual& a, double by_a, const Dual& b, double by_b) {
    Dual result(v);
    for (int i = 0; i < N; ++i)
      result.derivative[i] = by_a * a.derivative[i] + by_b * b.derivative[i];
    return result;
  }
  static Dual Of(double v, const Dual& a, double by_a) { return Of(v, a, by_a, a, 0.0); }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return Of(a.value + b.value, a, 1.0, b, 1.0);
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return Of(a.value - b.value, a, 1.0, b, -1.0);
  }
  friend Dual operator-(const Dual& a) { return Of(-a.value, a, -1.0); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return Of(a.value * b.value, a, b.value, b, a.value);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return Of(q, a, 1.0 / b.value, b, -q / b.value);
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return Of(root, a, 0.5 / root);
  }
  friend Dual exp(const Dual& a) {
    const double e = std::exp(a.value);
    return Of(e, a, e);
  }
  friend Dual log(const Dual& a) { return Of(std::log(a.value), a, 1.0 / a.value); }
  friend Dual sin(const Dual& a) { return Of(std::sin(a.value), a, std::cos(a.value)); }
  friend Dual cos(const Dual& a) { return Of(std::cos(a.value), a, -std::sin(a.value)); }
  friend Dual tanh(const Dual& a) {
    const double t = std::tanh(a.value);
    return Of(t, a, 1.0 - t * t);
  }
  friend Dual pow(const Dual& a, double exponent) {
    return Of(std::pow(a.value, exponent), a, exponent * std::pow(a.value, exponent - 1.0));
  }
  friend Dual abs(const Dual& a) { return a.value < 0.0 ? -a : a; }
};

}  // namespace clothfit::v0
