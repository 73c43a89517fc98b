// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Safe steps. Let n be a unit vector. The distance of two convex sets is at least the smallest
// n . (p_i - q_j) over their corners p_i and q_j, and these are linear in time. With n along the
// closest points the smallest is the distance itself. This bound is never worse than the speed
// bound of Li, Kaufman and Jiang 2021, alg. 1, and costs nothing for what slides past.
#include "autodiff_sim/contact/first_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothfit {
namespace {

// The first `First` points are the one convex set, the others the other.
template <int First>
class MovingPair {
 public:
  // Relative to the first point, so that rounding is that of the pair's size, not of its place.
  MovingPair(const FourPoints& x0, const FourPoints& x1) {
    double size = 0.0;
    for (int i = 0; i < 4; ++i) {
      x0_[i] = x0[i] - x0[0];
      velocity_[i] = (x1[i] - x1[0]) - x0_[i];
      size = std::max({size, x0_[i].norm(), velocity_[i].norm()});
    }
    rounding_ = 64.0 * std::numeric_limits<double>::epsilon() * size;
    for (int i = 0; i < First; ++i) {
      for (int j = First; j < 4; ++j) {
        speed_ = std::max(speed_, (velocity_[i] - velocity_[j]).norm());
      }
    }
  }

  double rounding() const { return rounding_; }

  double Distance(double t) {
    for (int i = 0; i < 4; ++i) x_[i] = x0_[i] + t * velocity_[i];
    if constexpr (First == 1) {
      const VertexTriangleClosest closest = ClosestVertexTriangle(x_);
      offset_ = closest.offset;
      distance_ = closest.distance;
    } else {
      const EdgeEdgeClosest closest = ClosestEdgeEdge(x_);
      offset_ = closest.offset;
      distance_ = closest.distance;
    }
    return distance_;
  }

  double SafeStep(double target) const {
    const Eigen::Vector3d n = offset_ / distance_;
    double step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < First; ++i) {
      for (int j = First; j < 4; ++j) {
        const double closing = n.dot(velocity_[j] - velocity_[i]);
        const double left = n.dot(x_[i] - x_[j]) - target;
        if (closing > 0.0) step = std::min(step, left / closing);
      }
    }
    // The bound by speed alone, for where n is inaccurate.
    return std::max(step, (distance_ - target) / speed_);
  }

 private:
  FourPoints x0_, velocity_, x_;
  Eigen::Vector3d offset_;
  double distance_ = 0.0, rounding_ = 0.0, speed_ = 0.0;
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
