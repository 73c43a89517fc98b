// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A pair of a feature of the cloth and one of an obstacle, as the obstacles' force needs it.
#pragma once

#include <array>

#include "autodiff_sim/base/scalar.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// By how much the obstacles stand elsewhere than the scene says, all alike.
struct ObstacleChange {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // m, world
  double growth = 0.0;                              // m, of the radii of balls and bars
};

// The radius (m) of an obstacle that has grown: of a mesh 0 as ever, of a ball or a bar never less
// than a tenth of what it was.
template <class T>
T GrownRadius(double radius, const T& growth) {
  if (radius == 0.0) return T(0.0);
  const T grown = growth + radius;
  return Value(grown) > 0.1 * radius ? grown : T(0.1 * radius);
}

struct ObstacleContact {
  PairKind kind;
  // Particles; those that the pair lacks repeat the first. Of the pair's four points, in the order
  // of PairVertices(), they are those from `first` on, `count` of them.
  std::array<int, 3> nodes;
  int first, count;
  // The obstacle's points (m) at the end of the step, in their places among the four, and their
  // velocities (m/s) during it. Where the scene says, as the radius: without an ObstacleChange.
  FourPoints points, velocities;
  double radius;    // m, of the obstacle around its points
  double area;      // m^2 of cloth that the pair stands for
  double parallel;  // m^4, as in ContactPair
  // The ground, as the last resort below the term `ground`: a plane through points[1], normal up.
  bool is_ground;
};

}  // namespace clothfit
