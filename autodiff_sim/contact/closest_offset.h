// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The offset between the closest points of a pair with its derivatives: which parts of the features
// (inside, edge, end) are closest is decided on plain values, by closest_points.h. The offset's
// length has a continuous gradient where one part takes over from another; the weights and the
// second derivatives jump there.
#pragma once

#include <array>

#include <Eigen/Geometry>

#include "autodiff_sim/base/scalar.h"
#include "autodiff_sim/contact/closest_points.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

template <class T>
struct ClosestOffset {
  // As in Contact: offset = sum of weight times place, from the second feature to the first.
  std::array<T, 4> weights;
  Vector3<T> offset;  // m
};

// Where on the line through a and b the point p is closest: 0 at a, 1 at b.
template <class T>
T AlongLine(const Vector3<T>& p, const Vector3<T>& a, const Vector3<T>& b) {
  const Vector3<T> side = b - a, to = p - a;
  return to.dot(side) / side.dot(side);
}

// The closest points of a vertex x[0] and a triangle, in the region that `plain` has found.
template <class T>
std::array<T, 4> VertexTriangleWeights(const std::array<Vector3<T>, 4>& x,
                                       const VertexTriangleClosest& plain) {
  std::array<T, 4> weights = {T(1.0), T(0.0), T(0.0), T(0.0)};
  std::array<int, 3> inside = {0, 0, 0};  // corners with a share
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    if (plain.weights[i] != 0.0) inside[count++] = i + 1;
  }
  if (count == 1) {
    weights[inside[0]] = T(-1.0);
  } else if (count == 2) {
    const T s = AlongLine<T>(x[0], x[inside[0]], x[inside[1]]);
    weights[inside[0]] = s - 1.0;
    weights[inside[1]] = -s;
  } else {
    const Vector3<T> side1 = x[2] - x[1], side2 = x[3] - x[1], r = x[0] - x[1];
    const Vector3<T> normal = side1.cross(side2);
    const T inverse = T(1.0) / normal.dot(normal);
    const T w2 = r.cross(side2).dot(normal) * inverse, w3 = side1.cross(r).dot(normal) * inverse;
    weights[1] = w2 + w3 - 1.0;
    weights[2] = -w2;
    weights[3] = -w3;
  }
  return weights;
}

// The same for the edges from x[0] to x[1] and from x[2] to x[3].
template <class T>
std::array<T, 4> EdgeEdgeWeights(const std::array<Vector3<T>, 4>& x, const EdgeEdgeClosest& plain) {
  const auto is_end = [](double along) { return along == 0.0 || along == 1.0; };
  T s(plain.along[0]), t(plain.along[1]);
  if (!is_end(plain.along[0]) && !is_end(plain.along[1])) {
    const Vector3<T> first = x[1] - x[0], second = x[3] - x[2], between = x[2] - x[0];
    const Vector3<T> cross = first.cross(second);
    const T inverse = T(1.0) / cross.dot(cross);
    s = between.cross(second).dot(cross) * inverse;
    t = between.cross(first).dot(cross) * inverse;
  } else if (!is_end(plain.along[0])) {
    s = AlongLine<T>(plain.along[1] == 0.0 ? x[2] : x[3], x[0], x[1]);
  } else if (!is_end(plain.along[1])) {
    t = AlongLine<T>(plain.along[0] == 0.0 ? x[0] : x[1], x[2], x[3]);
  }
  return {1.0 - s, s, t - 1.0, -t};
}

template <class T>
ClosestOffset<T> FindClosestOffset(PairKind kind, const FourPoints& plain,
                                   const std::array<Vector3<T>, 4>& x) {
  ClosestOffset<T> closest;
  closest.weights = kind == PairKind::kEdgeEdge
                        ? EdgeEdgeWeights<T>(x, ClosestEdgeEdge(plain))
                        : VertexTriangleWeights<T>(x, ClosestVertexTriangle(plain));
  // Relative to the first point, since the weights sum to 0: rounding is that of the pair's size.
  closest.offset = (x[1] - x[0]) * closest.weights[1] + (x[2] - x[0]) * closest.weights[2] +
                   (x[3] - x[0]) * closest.weights[3];
  return closest;
}

}  // namespace clothfit
