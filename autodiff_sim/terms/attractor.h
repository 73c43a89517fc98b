// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A place in the world that draws the cloth, such as a charge or a draught into a hole: per area
//   f = -stiffness d exp(-d^2 / (2 range^2)),
// d the offset from the place: a spring nearby, strongest at the range, nothing far away. It has
// the energy -stiffness range^2 exp(-d^2 / (2 range^2)) per area. A negative stiffness repels.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/obstacle.h"

namespace clothfit {

struct Attractor : TermDefaults {
  static constexpr const char* kName = "attractor";
  static constexpr const char* kTitle = "attraction to a place";
  static constexpr const char* kDoc = "a place in the world that draws the cloth";
  static constexpr const char* kReference = "spring that fades with the distance";
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 5> kParameters = {{
      {"stiffness", "Pa/m", "force per area and distance", 0.0, 0.0, -1e5, 1e5, Scale::kLinear,
       10.0},
      PlaceInWorld("x", Meaning::kPlaceX, "the place"),
      PlaceInWorld("y", Meaning::kPlaceY, "the place"),
      PlaceInWorld("z", Meaning::kPlaceZ, "the place"),
      Shape({"range", "m", "distance at which it is strongest", 0.1, 0.1, 0.005, 10.0, Scale::kLog,
             2.0},
            Meaning::kNumber, 0.05, 0.2),
  }};
  using Element = AreaElement;
  static std::vector<Element> Elements(const TermContext& context) { return AreaElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Attractor, T>& in,
                       ElementOutput<Attractor, T>* out) {
    using std::exp;
    const std::array<T, 5>& p = in.parameter;
    const Vector3<T> offset = in.x[0] - Vector3<T>(p[1], p[2], p[3]);
    const T fading = exp(-0.5 * offset.dot(offset) / (p[4] * p[4]));
    out->force[0] -= offset * (p[0] * element.area * fading);
  }
};

}  // namespace clothfit
