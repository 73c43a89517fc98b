// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Let n be a unit vector. The distance of two convex sets is at least the smallest n . (p_i - q_j)
// over their corners p_i and q_j, whatever n is, and it is just that for n along the closest
// points. Each of these numbers is linear in time, so it is known how long they all stay above 0.
// Unlike the bound by speed of Li, Kaufman and Jiang 2021, alg. 1, this one has no fear of closest
// points that are inaccurate, and what slides past costs nothing.
#include "autodiff_sim/contact/first_approach.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

// The first `First` points are the one convex set, the others the other.
template <int First>
class MovingPair {
 public:
  // Relative to the first point, so that rounding is that of the pair's size, not of its place.
  MovingPair(const FourPoints& x0, const FourPoints& x1) {
    double size = 0.0;  // m, of the pair and of its motion
    for (int i = 0; i < 4; ++i) {
      x0_[i] = x0[i] - x0[0];
      velocity_[i] = (x1[i] - x1[0]) - x0_[i];
      size = std::max({size, x0_[i].norm(), velocity_[i].norm()});
    }
    rounding_ = 64.0 * std::numeric_limits<double>::epsilon() * size;
  }

  double rounding() const { return rounding_; }

  // The separation along the best n that is at hand, which is the distance but for rounding.
  double Distance(double t) {
    for (int i = 0; i < 4; ++i) x_[i] = x0_[i] + t * velocity_[i];
    const auto [offset, distance] = Closest();
    normal_ = offset / distance;
    if (!(distance > 0.0)) return 0.0;
    const double separation = SeparationAlong(normal_);
    if (separation > kAccurate * distance) return separation;
    // The offset is so short that it has few digits left. Across both edges, or across the
    // triangle, n keeps them.
    Eigen::Vector3d across = Across();
    if (across.dot(offset) < 0.0) across = -across;
    const double separation_across = SeparationAlong(across);
    if (separation_across <= separation) return separation;
    normal_ = across;
    return separation_across;
  }

  double SafeStep(double target) const {
    double step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < First; ++i) {
      for (int j = First; j < 4; ++j) {
        const double closing = normal_.dot(velocity_[j] - velocity_[i]);
        const double left = normal_.dot(x_[i] - x_[j]) - target;
        if (closing > 0.0) step = std::min(step, left / closing);
      }
    }
    return step;
  }

 private:
  static constexpr double kAccurate = 0.999;

  std::pair<Eigen::Vector3d, double> Closest() const {
    if constexpr (First == 1) {
      const VertexTriangleClosest closest = ClosestVertexTriangle(x_);
      return {closest.offset, closest.distance};
    } else {
      const EdgeEdgeClosest closest = ClosestEdgeEdge(x_);
      return {closest.offset, closest.distance};
    }
  }

  // A unit vector, or 0 where there is none.
  Eigen::Vector3d Across() const {
    const Eigen::Vector3d first = First == 1 ? x_[2] - x_[1] : x_[1] - x_[0];
    const Eigen::Vector3d second = First == 1 ? x_[3] - x_[1] : x_[3] - x_[2];
    return first.cross(second).normalized();
  }

  double SeparationAlong(const Eigen::Vector3d& n) const {
    double separation = std::numeric_limits<double>::infinity();
    for (int i = 0; i < First; ++i) {
      for (int j = First; j < 4; ++j) {
        separation = std::min(separation, n.dot(x_[i] - x_[j]));
      }
    }
    return separation;
  }

  FourPoints x0_, velocity_, x_;
  Eigen::Vector3d normal_;
  double rounding_ = 0.0;  // m
};

}  // namespace

std::optional<double> FirstVertexTriangleApproach(const FourPoints& x0, const FourPoints& x1,
                                                  const Approach& approach, double until) {
  MovingPair<1> pair(x0, x1);
  return Advance(approach, until, &pair);
}

std::optional<double> FirstEdgeEdgeApproach(const FourPoints& x0, const FourPoints& x1,
                                            const Approach& approach, double until) {
  MovingPair<2> pair(x0, x1);
  return Advance(approach, until, &pair);
}

}  // namespace clothfit
