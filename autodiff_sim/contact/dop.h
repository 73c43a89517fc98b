// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Discrete oriented polytopes (k-DOPs): bounding volumes between pairs of parallel planes, k planes
// in all. Klosowski et al. 1998, "Efficient collision detection using bounding volume hierarchies
// of k-DOPs"; Mezger, Kimmerle and Etzmuss 2002 found 14 planes to be the best for cloth (Hasler
// 2007, sec. 3.2 and fig. 3).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace clothfit {

// The directions that the planes stand across, not of unit length, so that a projection is a sum:
//    6: the axes, which makes an axis-aligned box
//   14: the axes and the four diagonals between corners of a cube
//   18: the axes and the six diagonals between edges of a cube
//   26: all of these, in this order
template <int Planes>
class Dop {
 public:
  static_assert(Planes == 6 || Planes == 14 || Planes == 18 || Planes == 26);
  static constexpr int kDirections = Planes / 2;
  using Values = std::array<double, kDirections>;

  // An empty one: it overlaps nothing, and may not be inflated.
  Dop() {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
  }

  // A point (m) along every direction.
  static Values Project(const Eigen::Vector3d& p);
  // The lengths of the directions: 1, sqrt(3) or sqrt(2).
  static Values Lengths();

  void Extend(const Eigen::Vector3d& p) {
    const Values values = Project(p);
    for (int i = 0; i < kDirections; ++i) {
      low_[i] = std::min(low_[i], values[i]);
      high_[i] = std::max(high_[i], values[i]);
    }
  }

  void Merge(const Dop& other) {
    for (int i = 0; i < kDirections; ++i) {
      low_[i] = std::min(low_[i], other.low_[i]);
      high_[i] = std::max(high_[i], other.high_[i]);
    }
  }

  // Moves every plane outwards by `margin` (m, 0 or more) and by the rounding of the projections.
  // Two sets of points, each inflated by half of a distance, overlap wherever points of their
  // convex hulls are within that distance; with a margin of 0, wherever the hulls touch.
  void Inflate(double margin);

  // Touching counts.
  bool Overlaps(const Dop& other) const {
    for (int i = 0; i < kDirections; ++i) {
      if (low_[i] > other.high_[i] || other.low_[i] > high_[i]) return false;
    }
    return true;
  }

  // m^2, of a point from the axis-aligned box around it: no more than from anything in it.
  double SquaredDistanceToBox(const Eigen::Vector3d& p) const {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double gap = std::max({low_[i] - p[i], p[i] - high_[i], 0.0});
      sum += gap * gap;
    }
    return sum;
  }

  // m times the length of the direction.
  const Values& low() const { return low_; }
  const Values& high() const { return high_; }

 private:
  Values low_, high_;
};

template <int Planes>
typename Dop<Planes>::Values Dop<Planes>::Project(const Eigen::Vector3d& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  if constexpr (Planes == 6) {
    return {x, y, z};
  } else if constexpr (Planes == 14) {
    return {x, y, z, x + y + z, x + y - z, x - y + z, x - y - z};
  } else if constexpr (Planes == 18) {
    return {x, y, z, x + y, x + z, y + z, x - y, x - z, y - z};
  } else {
    return {x,     y,     z,     x + y + z, x + y - z, x - y + z, x - y - z,
            x + y, x + z, y + z, x - y,     x - z,     y - z};
  }
}

template <int Planes>
typename Dop<Planes>::Values Dop<Planes>::Lengths() {
  constexpr int kCorners = Planes == 14 || Planes == 26 ? 4 : 0;
  Values lengths;
  for (int i = 0; i < kDirections; ++i) {
    lengths[i] = std::sqrt(i < 3 ? 1.0 : i < 3 + kCorners ? 3.0 : 2.0);
  }
  return lengths;
}

template <int Planes>
void Dop<Planes>::Inflate(double margin) {
  double largest = margin;  // m, of what is added up in a projection
  for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(low_[i]), std::abs(high_[i])});
  // A projection takes two sums of at most three times the largest coordinate, and inflating one
  // more; the product with the length is another. Twice that, since bounds are compared in pairs.
  const double rounding = 24.0 * std::numeric_limits<double>::epsilon() * largest;
  static const Values kLengths = Lengths();
  for (int i = 0; i < kDirections; ++i) {
    const double outwards = margin * kLengths[i] + rounding;
    low_[i] -= outwards;
    high_[i] += outwards;
  }
}

}  // namespace clothfit
