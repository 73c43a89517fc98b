// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Limits of stretch and compression: beside each spring along warp, weft and bias a second one that
// acts only beyond a strain, so that the force over the strain is steep there and as it was before,
// the piecewise linear stand-in for cloth that is not linear. Provot 1995 ("Deformation constraints
// in a mass-spring model to describe rigid cloth behavior") moves the ends of such springs after
// the step; a force inside the implicit step has derivatives and takes and gives no energy. Its
// slope sets in over a strain of kSoft, so that it is continuous:
//   tension per width = stiffness p(e - stretch) - stiffness p(-e - compression),  e = l / l_0 - 1,
//   p(z) = 0 below 0, z^2 / (2 kSoft) up to kSoft, z - kSoft / 2 beyond.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct StrainLimit : TermDefaults {
  static constexpr const char* kName = "strain_limit";
  static constexpr const char* kDoc = "springs that are steep beyond a stretch or compression";
  static constexpr const char* kReference = "Provot 1995, as a force";
  static constexpr Role kRole = Role::kVariant;
  static constexpr int kNodes = 2;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  static constexpr double kSoft = 0.01;
  static constexpr std::array<Parameter, 3> kParameters = {{
      {"stiffness", "N/m", "membrane stiffness beyond the limits, on top of that before", 0.0, 0.0,
       0.0, 1e6, Scale::kLinear, 1e3},
      Shape({"stretch", "1", "strain beyond which springs are steep", 0.1, 0.1, 0.0, 0.5,
             Scale::kLinear, 0.05},
            Meaning::kNumber, 0.02, 0.05, 0.1),
      Shape({"compression", "1", "the same of shortening; 1: never", 0.1, 0.1, 0.0, 1.0,
             Scale::kLinear, 0.05},
            Meaning::kNumber, 0.05, 0.1),
  }};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> springs = context.topology.structural;
    const std::vector<Element>& bias = context.topology.shear;
    springs.insert(springs.end(), bias.begin(), bias.end());
    return springs;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StrainLimit, T>& in,
                       ElementOutput<StrainLimit, T>* out) {
    using std::sqrt;
    const Vector3<T> dx = in.x[1] - in.x[0];
    const T length = sqrt(dx.dot(dx));
    const T rest_length = RestLength<T>(element, in.shrinkage);
    const T strain = length / rest_length - 1.0;
    const T beyond = Beyond<T>(strain - in.parameter[1]) - Beyond<T>(-strain - in.parameter[2]);
    if (Value(beyond) == 0.0) return;
    const T pull = in.parameter[0] * beyond * rest_length * element.weight / length;
    for (int k = 0; k < 3; ++k) {
      out->force[0][k] += pull * dx[k];
      out->force[1][k] -= pull * dx[k];
    }
  }

 private:
  template <class T>
  static T Beyond(const T& z) {
    if (Value(z) <= 0.0) return T(0.0);
    if (Value(z) < kSoft) return z * z * (0.5 / kSoft);
    return z - 0.5 * kSoft;
  }
};

}  // namespace clothfit
