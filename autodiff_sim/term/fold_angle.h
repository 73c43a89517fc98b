// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The angle between two triangles that share an edge, and its gradient, Bridson, Marino and Fedkiw
// 2003, sec. 4; particles in the order of Hinge::nodes.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

template <class T>
struct Fold {
  Vector3<T> edge;              // m
  Vector3<T> normal1, normal2;  // m^2, twice the triangles' areas long
  T length;                     // m, of the edge
  T angle;                      // rad, 0 where it is flat, positive to one side, up to +-pi
};

template <class T>
Fold<T> MakeFold(const std::array<Vector3<T>, 4>& x) {
  using std::atan2;
  using std::sqrt;
  Fold<T> fold;
  fold.edge = x[3] - x[2];
  const Vector3<T> a = x[0] - x[2], b = x[0] - x[3], c = x[1] - x[3], d = x[1] - x[2];
  fold.normal1 = a.cross(b);
  fold.normal2 = c.cross(d);
  fold.length = sqrt(fold.edge.dot(fold.edge));
  fold.angle = atan2(fold.normal1.cross(fold.normal2).dot(fold.edge) / fold.length,
                     fold.normal1.dot(fold.normal2));
  return fold;
}

// Minus the angle's gradient, 1/m, particle by particle: Bridson's u_1 ... u_4, along which forces
// flatten a fold of positive angle without moving or stretching it.
template <class T>
std::array<Vector3<T>, 4> FlatteningMode(const std::array<Vector3<T>, 4>& x, const Fold<T>& fold) {
  const Vector3<T> a = x[0] - x[2], b = x[0] - x[3], c = x[1] - x[3], d = x[1] - x[2];
  const T w1 = fold.length / fold.normal1.dot(fold.normal1);
  const T w2 = fold.length / fold.normal2.dot(fold.normal2);
  const T inverse = T(1.0) / (fold.length * fold.length);
  const T s1 = b.dot(fold.edge) * inverse, s2 = c.dot(fold.edge) * inverse;
  const T t1 = -a.dot(fold.edge) * inverse, t2 = -d.dot(fold.edge) * inverse;
  std::array<Vector3<T>, 4> u;
  for (int k = 0; k < 3; ++k) {
    const T g1 = w1 * fold.normal1[k], g2 = w2 * fold.normal2[k];
    u[0][k] = g1;
    u[1][k] = g2;
    u[2][k] = s1 * g1 + s2 * g2;
    u[3][k] = t1 * g1 + t2 * g2;
  }
  return u;
}

// Adds a moment (N m) that flattens a positive angle.
template <class T>
void AddFlatteningMoment(const T& moment, const std::array<Vector3<T>, 4>& mode,
                         std::array<Vector3<T>, 4>* force) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) (*force)[i][k] += moment * mode[i][k];
  }
}

}  // namespace clothfit
