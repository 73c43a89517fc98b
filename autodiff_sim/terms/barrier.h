// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The barrier of Li et al. 2020 ("Incremental potential contact", eq. 6) without units,
//   b(s) = -(1 - s)^2 ln s,  s = gap / thickness in (0, 1),
// and the factor that fades out two edges that become parallel (ibid., eq. 24): c is the squared
// length of their cross product, m = c/e (2 - c/e) below e and 1 above.
#pragma once

#include <cmath>

#include "autodiff_sim/contact/feature_pair.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// -b'(s): above 0 and falling, 0 at s = 1 with slope 0.
template <class T>
T BarrierSlope(const T& s) {
  using std::log;
  const T open = T(1.0) - s;
  return open * (open / s - 2.0 * log(s));
}

// b(s).
template <class T>
T Barrier(const T& s) {
  using std::log;
  const T open = T(1.0) - s;
  return open * open * (-log(s));
}

// b''(s), above 0.
inline double BarrierCurvature(double s) {
  const double open = 1.0 - s;
  return -2.0 * std::log(s) + 4.0 * open / s + open * open / (s * s);
}

// m of the edges from x[0] to x[1] and from x[2] to x[3]; `parallel` is e, m^4.
inline double Fading(const FourPoints& x, double parallel) {
  const double share = (x[1] - x[0]).cross(x[3] - x[2]).squaredNorm() / parallel;
  return share < 1.0 ? share * (2.0 - share) : 1.0;
}

// m, and what it does to the edges from x[0] to x[1] and from x[2] to x[3]: adds -energy grad m.
template <class T>
T AddFadingForce(const std::array<Vector3<T>, 4>& x, double parallel, const T& energy,
                 std::array<Vector3<T>, 4>* force) {
  const Vector3<T> first = x[1] - x[0], second = x[3] - x[2];
  const Vector3<T> cross = first.cross(second);
  const T share = cross.dot(cross) * (1.0 / parallel);
  if (Value(share) >= 1.0) return T(1.0);
  const T slope = energy * (T(1.0) - share) * (4.0 / parallel);
  const Vector3<T> by_first = second.cross(cross) * slope;
  const Vector3<T> by_second = cross.cross(first) * slope;
  (*force)[0] += by_first;
  (*force)[1] -= by_first;
  (*force)[2] += by_second;
  (*force)[3] -= by_second;
  return share * (T(2.0) - share);
}

}  // namespace clothfit
