// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Stretch that stiffens: beside the linear springs along warp and weft a cubic one, which sets in
// at a strain as the threads straighten,
//   tension per width = cubic (e - onset)^3 where e > onset,  e = l / l_0 - 1,
// smooth up to its second derivative, where Provot 1995 limits the strain. It pulls and does not
// push: compressed cloth buckles.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct StretchStiffening : TermDefaults {
  static constexpr const char* kName = "stretch_stiffening";
  static constexpr const char* kDoc = "stretching that stiffens beyond a strain";
  static constexpr const char* kReference = "cubic law; in the place of the limit of Provot 1995";
  static constexpr int kNodes = 2;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"cubic", "N/m", "tension per width, over the cube of the strain beyond the onset", 0.0, 0.0,
       0.0, 1e8, Scale::kLinear, 1e5},
      Shape({"onset", "1", "strain at which it sets in", 0.0, 0.0, 0.0, 0.1, Scale::kLinear, 0.02},
            Meaning::kNumber, 0.0, 0.02, 0.05),
  }};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.structural;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StretchStiffening, T>& in,
                       ElementOutput<StretchStiffening, T>* out) {
    using std::sqrt;
    const Vector3<T> dx = in.x[1] - in.x[0];
    const T length = sqrt(dx.dot(dx));
    const T rest_length = RestLength<T>(element, in.shrinkage);
    const T beyond = length / rest_length - 1.0 - in.parameter[1];
    if (Value(beyond) <= 0.0) return;
    const T pull =
        in.parameter[0] * beyond * beyond * beyond * rest_length * element.weight / length;
    for (int k = 0; k < 3; ++k) {
      out->force[0][k] += pull * dx[k];
      out->force[1][k] -= pull * dx[k];
    }
  }
};

}  // namespace clothfit
