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
  Vector3<T> side1, side2, edge;  // m, from node 2 to nodes 0, 1 and 3
  Vector3<T> normal1, normal2;    // m^2, twice the triangles' areas long
  T length;                       // m, of the edge
  T sine, cosine;                 // m^4, of the angle, times the lengths of both normals
};

template <class T>
Fold<T> MakeFold(const std::array<Vector3<T>, 4>& x) {
  using std::sqrt;
  Fold<T> fold;
  fold.side1 = x[0] - x[2];
  fold.side2 = x[1] - x[2];
  fold.edge = x[3] - x[2];
  fold.normal1 = fold.edge.cross(fold.side1);
  fold.normal2 = fold.side2.cross(fold.edge);
  fold.length = sqrt(fold.edge.dot(fold.edge));
  fold.sine = -fold.length * fold.normal1.dot(fold.side2);  // (N1 x N2) . E / |E|
  fold.cosine = fold.normal1.dot(fold.normal2);
  return fold;
}

// rad, 0 where it is flat, positive to one side, up to +-pi.
template <class T>
T FoldAngle(const Fold<T>& fold) {
  using std::atan2;
  return atan2(fold.sine, fold.cosine);
}

// Sine and cosine of half the angle, without the angle.
template <class T>
struct HalfAngle {
  T sine, cosine;
};
template <class T>
HalfAngle<T> HalveAngle(const Fold<T>& fold) {
  using std::sqrt;
  const T size = sqrt(fold.sine * fold.sine + fold.cosine * fold.cosine);
  const bool is_obtuse = Value(fold.cosine) < 0.0;
  // Of the two whichever does not cancel gives the other.
  const T larger = sqrt((is_obtuse ? size - fold.cosine : size + fold.cosine) / (2.0 * size));
  const T smaller = fold.sine / (2.0 * size * larger);
  if (!is_obtuse) return {smaller, larger};
  return Value(fold.sine) < 0.0 ? HalfAngle<T>{-larger, -smaller} : HalfAngle<T>{larger, smaller};
}

// Minus the angle's gradient, 1/m, particle by particle: Bridson's u_1 ... u_4, along which forces
// flatten a fold of positive angle without moving or stretching it.
template <class T>
std::array<Vector3<T>, 4> FlatteningMode(const Fold<T>& fold) {
  const T w1 = fold.length / fold.normal1.dot(fold.normal1);
  const T w2 = fold.length / fold.normal2.dot(fold.normal2);
  const T inverse = -1.0 / (fold.length * fold.length);
  const T t1 = fold.side1.dot(fold.edge) * inverse, t2 = fold.side2.dot(fold.edge) * inverse;
  std::array<Vector3<T>, 4> u;
  for (int k = 0; k < 3; ++k) {
    u[0][k] = w1 * fold.normal1[k];
    u[1][k] = w2 * fold.normal2[k];
    u[3][k] = t1 * u[0][k] + t2 * u[1][k];
    u[2][k] = -(u[0][k] + u[1][k] + u[3][k]);
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
