// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Convex obstacles with a closed form for the signed distance to their surface, negative inside.
// Each stands in a frame of its own, the body's. Distances are templated on their scalar, and so
// are their gradients, which are of length 1: with ceres::Jet or Dual for the scalar the gradient
// carries the second derivatives.
#pragma once

#include <array>
#include <cmath>
#include <variant>

#include "autodiff_sim/base/scalar.h"
#include "autodiff_sim/contact/rigid_pose.h"

namespace clothfit {

template <class T>
struct SignedDistance {
  T distance;           // m
  Vector3<T> gradient;  // of the distance by the point; where it has several, one of them
};

// The half of space below the plane z = 0.
struct HalfSpace {
  template <class T>
  SignedDistance<T> Distance(const Vector3<T>& p) const {
    return {p.z(), Vector3<T>(T(0.0), T(0.0), T(1.0))};
  }
};

// Everything within `radius` of the line from -half_length to half_length on the z axis; a sphere
// where half_length is 0.
struct Capsule {
  double radius = 0.0;       // m, above 0
  double half_length = 0.0;  // m, of the line

  template <class T>
  SignedDistance<T> Distance(const Vector3<T>& p) const {
    using std::sqrt;
    Vector3<T> q(p.x(), p.y(), T(0.0));  // from the line's closest point
    if (Value(p.z()) > half_length) q.z() = p.z() - T(half_length);
    if (Value(p.z()) < -half_length) q.z() = p.z() + T(half_length);
    const T squared = q.x() * q.x() + q.y() * q.y() + q.z() * q.z();
    if (!(Value(squared) > 0.0)) {
      return {T(-radius), Vector3<T>(T(1.0), T(0.0), T(0.0))};
    }
    const T length = sqrt(squared);
    return {length - T(radius), Vector3<T>(q.x() / length, q.y() / length, q.z() / length)};
  }
};

inline Capsule Sphere(double radius) { return {radius, 0.0}; }

// |x|, |y|, |z| up to half the sides.
struct Box {
  std::array<double, 3> half_sides = {0.0, 0.0, 0.0};  // m, above 0

  template <class T>
  SignedDistance<T> Distance(const Vector3<T>& p) const {
    using std::sqrt;
    Vector3<T> outside(T(0.0), T(0.0), T(0.0));  // from the box's closest point
    int nearest = 0;                             // the axis of the face that is nearest from inside
    for (int k = 0; k < 3; ++k) {
      if (Depth(p, k) < Depth(p, nearest)) nearest = k;
      if (Depth(p, k) < 0.0) outside[k] = p[k] - T(Sign(p[k]) * half_sides[k]);
    }
    if (Depth(p, nearest) >= 0.0) {
      const double sign = Sign(p[nearest]);
      Vector3<T> gradient(T(0.0), T(0.0), T(0.0));
      gradient[nearest] = T(sign);
      return {T(sign) * p[nearest] - T(half_sides[nearest]), gradient};
    }
    const T length =
        sqrt(outside[0] * outside[0] + outside[1] * outside[1] + outside[2] * outside[2]);
    return {length, Vector3<T>(outside[0] / length, outside[1] / length, outside[2] / length)};
  }

 private:
  template <class T>
  static double Sign(const T& value) {
    return Value(value) < 0.0 ? -1.0 : 1.0;
  }
  // m, below the closer face across the axis; negative outside.
  template <class T>
  double Depth(const Vector3<T>& p, int k) const {
    return half_sides[k] - std::abs(Value(p[k]));
  }
};

using ObstacleShape = std::variant<HalfSpace, Capsule, Box>;

// Of a point in the world, m; the gradient is by the point in the world too.
template <class T>
SignedDistance<T> DistanceInWorld(const ObstacleShape& shape, const RigidPose& pose,
                                  const Vector3<T>& point) {
  const Eigen::Matrix3d& r = pose.world_from_body;
  Vector3<T> from_origin, in_body;
  for (int k = 0; k < 3; ++k) from_origin[k] = point[k] - T(pose.origin_in_world[k]);
  for (int k = 0; k < 3; ++k) {
    in_body[k] =
        T(r(0, k)) * from_origin[0] + T(r(1, k)) * from_origin[1] + T(r(2, k)) * from_origin[2];
  }
  const SignedDistance<T> found =
      std::visit([&](const auto& body) { return body.template Distance<T>(in_body); }, shape);
  SignedDistance<T> turned{found.distance, {}};
  for (int k = 0; k < 3; ++k) {
    turned.gradient[k] = T(r(k, 0)) * found.gradient[0] + T(r(k, 1)) * found.gradient[1] +
                         T(r(k, 2)) * found.gradient[2];
  }
  return turned;
}

}  // namespace clothfit
