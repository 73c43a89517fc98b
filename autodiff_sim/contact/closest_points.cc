// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Both queries try the inside first, where the closest points are those of a plane or of two lines,
// and then the boundary. Every candidate is a pair of points of the two, so no candidate is too
// close; and one that rounding has made inaccurate has to compete with those of the boundary.
#include "autodiff_sim/contact/closest_points.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

using Eigen::Vector3d;

// Squared sine of an angle, below which the inside is not trusted alone.
constexpr double kThin = 1e-8;

// Where on the segment from a to b p is closest to it: 0 at a, 1 at b.
double ClosestOnSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d side = b - a;
  const double length_squared = side.squaredNorm();
  if (!(length_squared > 0.0)) return 0.0;
  return std::clamp((p - a).dot(side) / length_squared, 0.0, 1.0);
}

}  // namespace

VertexTriangleClosest ClosestVertexTriangle(const FourPoints& x) {
  const Vector3d side1 = x[2] - x[1], side2 = x[3] - x[1], r = x[0] - x[1];
  const Vector3d normal = side1.cross(side2);
  const double normal_squared = normal.squaredNorm();
  VertexTriangleClosest closest;
  bool found = false;
  const auto offer = [&](double w0, double w1, double w2) {
    const Vector3d offset = r - (w1 * side1 + w2 * side2);
    const double distance = offset.norm();
    if (found && distance >= closest.distance) return;
    closest = {{w0, w1, w2}, offset, distance};
    found = true;
  };
  if (normal_squared > 0.0) {
    const double w1 = r.cross(side2).dot(normal) / normal_squared;
    const double w2 = side1.cross(r).dot(normal) / normal_squared;
    const double w0 = 1.0 - w1 - w2;
    if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0) {
      offer(w0, w1, w2);
      if (normal_squared > kThin * side1.squaredNorm() * side2.squaredNorm()) return closest;
    }
  }
  const double s = ClosestOnSegment(x[0], x[1], x[2]);
  offer(1.0 - s, s, 0.0);
  const double t = ClosestOnSegment(x[0], x[2], x[3]);
  offer(0.0, 1.0 - t, t);
  const double u = ClosestOnSegment(x[0], x[3], x[1]);
  offer(u, 0.0, 1.0 - u);
  return closest;
}

EdgeEdgeClosest ClosestEdgeEdge(const FourPoints& x) {
  const Vector3d first = x[1] - x[0], second = x[3] - x[2], between = x[2] - x[0];
  const Vector3d cross = first.cross(second);
  EdgeEdgeClosest closest;
  closest.cross_squared = cross.squaredNorm();
  bool found = false;
  const auto offer = [&](double s, double t) {
    const Vector3d offset = s * first - (between + t * second);
    const double distance = offset.norm();
    if (found && distance >= closest.distance) return;
    closest.along = {s, t};
    closest.offset = offset;
    closest.distance = distance;
    found = true;
  };
  if (closest.cross_squared > 0.0) {
    const double s = between.cross(second).dot(cross) / closest.cross_squared;
    const double t = between.cross(first).dot(cross) / closest.cross_squared;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
      offer(s, t);
      if (closest.cross_squared > kThin * first.squaredNorm() * second.squaredNorm()) {
        return closest;
      }
    }
  }
  offer(0.0, ClosestOnSegment(x[0], x[2], x[3]));
  offer(1.0, ClosestOnSegment(x[1], x[2], x[3]));
  offer(ClosestOnSegment(x[2], x[0], x[1]), 0.0);
  offer(ClosestOnSegment(x[3], x[0], x[1]), 1.0);
  return closest;
}

}  // namespace clothfit
