// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A vortex of air that stands in the world, its axis vertical through (x, y): the air goes round it
// at the distance r with
//   w = speed (r / core) exp((1 - r^2 / core^2) / 2),
// fastest at the core's radius, after the decaying vortex of Taylor 1918. Felt through the normal
// part of the air drag, as wind is (terms/wind.h). For recordings of trials only: clothfit's own
// list of terms has nothing that turns.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/air_drag.h"

namespace clothfit {

struct Vortex : TermDefaults {
  static constexpr const char* kName = "vortex";
  static constexpr const char* kDoc = "air that goes round a vertical axis";
  static constexpr const char* kReference = "Taylor 1918, decaying vortex";
  static constexpr Work kWork = Work::kDrives;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr bool kPrefersAxes = true;
  static constexpr std::array<Parameter, 4> kParameters = {{
      {"speed", "m/s", "of the air at the core's radius, anticlockwise from above", 0.0, 0.0, -10.0,
       10.0, Scale::kLinear, 0.3},
      PlaceInWorld("x", Meaning::kPlaceX, "the axis"),
      PlaceInWorld("y", Meaning::kPlaceY, "the axis"),
      Shape({"core", "m", "radius at which the air is fastest", 0.1, 0.1, 0.01, 10.0, Scale::kLog,
             2.0},
            Meaning::kNumber, 0.1, 0.3),
  }};
  static constexpr std::array<const char*, 2> kReads = {"air_drag.normal", "air_drag.saturation"};

  using Element = AirDrag::Element;
  static std::vector<Element> Elements(const TermContext& context) {
    return AirDrag::Elements(context);
  }

  template <class T>
  static void AddForce(const Element&, const ElementInput<Vortex, T>& in,
                       ElementOutput<Vortex, T>* out) {
    using std::exp;
    const std::array<T, 4>& p = in.parameter;
    const Vector3<T> middle = (in.x[0] + in.x[1] + in.x[2]) * T(1.0 / 3.0);
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(1.0 / 3.0);
    const T x = (middle.x() - p[1]) / p[3], y = (middle.y() - p[2]) / p[3];
    const T turning = p[0] * exp((1.0 - x * x - y * y) * 0.5);
    const Vector3<T> air(-turning * y, turning * x, T(0.0));
    const std::array<T, 3> drag = {in.read[0], in.read[1], T(0.0)};
    const Vector3<T> force =
        AirDragForce<T>(in.x, velocity - air, drag) - AirDragForce<T>(in.x, velocity, drag);
    for (Vector3<T>& corner : out->force) corner += force;
  }
};

}  // namespace clothfit
