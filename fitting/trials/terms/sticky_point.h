// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A sticky place in space, such as a cobweb or a drop of glue on a wire: within its range it draws
// the cloth and slows it down. Per area
//   f = -(pull d / sqrt(range^2 + d^2) + viscosity v) / (1 + d^2 / range^2)^2,
// d the offset from the place. The draw is of another shape than the attractor's, and no term of
// clothfit's own list slows the cloth at a place of the world. For recordings of trials only.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/obstacle.h"

namespace clothfit {

struct StickyPoint : TermDefaults {
  static constexpr const char* kName = "sticky_point";
  static constexpr const char* kDoc = "a place in space that draws the cloth and slows it down";
  static constexpr const char* kReference = "pull and drag that fade with the distance";
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 6> kParameters = {{
      {"pull", "Pa", "about twice the largest pull per area", 0.0, 0.0, 0.0, 1e4, Scale::kLinear,
       1.0},
      {"viscosity", "Pa s/m", "drag per area and speed, at the place", 0.0, 0.0, 0.0, 1e4,
       Scale::kLinear, 1.0},
      PlaceInWorld("x", Meaning::kPlaceX, "the place"),
      PlaceInWorld("y", Meaning::kPlaceY, "the place"),
      PlaceInWorld("z", Meaning::kPlaceZ, "the place"),
      Shape({"range", "m", "distance at which the drag has fallen to a quarter", 0.05, 0.05, 0.005,
             1.0, Scale::kLog, 2.0},
            Meaning::kNumber, 0.02, 0.1),
  }};
  using Element = AreaElement;
  static std::vector<Element> Elements(const TermContext& context) { return AreaElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StickyPoint, T>& in,
                       ElementOutput<StickyPoint, T>* out) {
    using std::sqrt;
    const std::array<T, 6>& p = in.parameter;
    const Vector3<T> offset = in.x[0] - Vector3<T>(p[2], p[3], p[4]);
    const T square = offset.dot(offset), range2 = p[5] * p[5];
    const T near = range2 / (range2 + square);
    const T fading = near * near * element.area;
    const T draw = p[0] * fading / sqrt(range2 + square), slow = p[1] * fading;
    for (int k = 0; k < 3; ++k) out->force[0][k] -= draw * offset[k] + slow * in.v[0][k];
  }
};

}  // namespace clothfit
