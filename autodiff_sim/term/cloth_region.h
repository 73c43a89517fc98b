// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Places on the cloth, and how much of what is there an element gets: smooth, so that a place and a
// size have derivatives everywhere.
#pragma once

#include <cmath>

#include "autodiff_sim/mesh/cloth_box.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// The parameters of a patch,
constexpr Parameter kPatchU = Shape(
    {"u", "m", "place on the cloth, along the warp", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.1},
    Meaning::kClothU, 0.0, 0.5, 1.0);
constexpr Parameter kPatchV = Shape(
    {"v", "m", "place on the cloth, along the weft", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.1},
    Meaning::kClothV, 0.0, 0.5, 1.0);
constexpr Parameter kPatchRadius = Shape({"radius", "m", "distance at which it has fallen to 61 %",
                                          0.1, 0.1, 0.005, 10.0, Scale::kLog, 2.0},
                                         Meaning::kClothDistance, 0.1, 0.3);
// and of a straight line.
constexpr Parameter kLineAngle =
    Shape({"angle", "rad", "of the line, from the warp towards the weft", 0.0, 0.0, -M_PI, M_PI,
           Scale::kLinear, 0.3},
          Meaning::kNumber, 0.0, M_PI / 4, M_PI / 2, 3 * M_PI / 4);
constexpr Parameter kLineOffset =
    Shape({"offset", "m", "of the line from the cloth's middle, to its left", 0.0, 0.0, -10.0, 10.0,
           Scale::kLinear, 0.1},
          Meaning::kClothDistance, -0.25, 0.0, 0.25);

// Middle of the box around the cloth's (u, v), m.
inline Eigen::Vector2d MiddleOfCloth(const ClothMesh& mesh) {
  const ClothBox box = BoxOf(mesh);
  return 0.5 * (box.low + box.high);
}

// (u, v) of the middle of an element, m.
template <std::size_t kNodes>
Eigen::Vector2d MiddleOf(const std::array<int, kNodes>& nodes, const ClothMesh& mesh) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const int node : nodes) sum += mesh.uv[node];
  return sum / static_cast<double>(kNodes);
}

// 1 at a place, falling with the distance from it as a Gauss curve of this radius does, m: to 61 %
// at the radius and to 1 % at three of it.
template <class T>
T PatchWeight(const Eigen::Vector2d& uv, const T& u, const T& v, const T& radius) {
  using std::exp;
  const T du = uv.x() - u, dv = uv.y() - v;
  return exp(-0.5 * (du * du + dv * dv) / (radius * radius));
}

// Signed distance (m) of a place, given from the middle of the cloth, to the straight line that
// runs at `angle` (rad) from the warp towards the weft, `offset` (m) to the left of the middle.
template <class T>
T DistanceToLine(const Eigen::Vector2d& from_middle, const T& angle, const T& offset) {
  using std::cos;
  using std::sin;
  return from_middle.y() * cos(angle) - from_middle.x() * sin(angle) - offset;
}

// The same curve across a line.
template <class T>
T SeamWeight(const Eigen::Vector2d& from_middle, const T& angle, const T& offset, const T& width) {
  using std::exp;
  const T distance = DistanceToLine<T>(from_middle, angle, offset);
  return exp(-0.5 * distance * distance / (width * width));
}

}  // namespace clothfit
