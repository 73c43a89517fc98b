// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions about the one that gravity has, from two small angles.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// Down, and two axes across it, all unit vectors of the world. Where gravity is along -z the axes
// are x and y; there is none without gravity, and -z is taken.
struct DownFrame {
  Eigen::Vector3d down, axis_1, axis_2;
};

inline DownFrame MakeDownFrame(const Eigen::Vector3d& gravity) {
  DownFrame frame;
  frame.down = gravity.norm() > 0.0 ? gravity.normalized() : -Eigen::Vector3d::UnitZ();
  constexpr double kAlong = 0.9;
  const bool is_x = std::abs(frame.down.x()) > kAlong;
  const Eigen::Vector3d near = is_x ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  frame.axis_1 = (near - frame.down * near.dot(frame.down)).normalized();
  frame.axis_2 = frame.axis_1.cross(frame.down);
  return frame;
}

// Down, turned by the rotation vector angle_1 axis_1 + angle_2 axis_2 (rad): Rodrigues' formula,
// which is exactly down at zero angles.
template <class T>
Vector3<T> TiltedDown(const DownFrame& frame, const T& angle_1, const T& angle_2) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T square = angle_1 * angle_1 + angle_2 * angle_2;
  T cosine, sinc;
  constexpr double kSmall = 1e-4;  // rad^2, up to which three terms of the series are exact
  if (Value(square) < kSmall) {
    cosine = 1.0 - square * (1.0 / 2.0) * (1.0 - square * (1.0 / 12.0));
    sinc = 1.0 - square * (1.0 / 6.0) * (1.0 - square * (1.0 / 20.0));
  } else {
    const T angle = sqrt(square);
    cosine = cos(angle);
    sinc = sin(angle) / angle;
  }
  const Eigen::Vector3d turned_1 = frame.axis_1.cross(frame.down);
  const Eigen::Vector3d turned_2 = frame.axis_2.cross(frame.down);
  Vector3<T> tilted;
  for (int k = 0; k < 3; ++k)
    tilted[k] = cosine * frame.down[k] + sinc * (angle_1 * turned_1[k] + angle_2 * turned_2[k]);
  return tilted;
}

}  // namespace clothfit
