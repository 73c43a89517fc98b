// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction of the threads against each other where the angle between them changes: Dahl's law on
// the shear of each triangle,
//   shear stress = limit * z,  dz = (d gamma - z |d gamma|) / onset.
#pragma once

#include "autodiff_sim/term/dahl_friction.h"
#include "autodiff_sim/term/shear_strain.h"

namespace clothfit {

struct ShearFriction : TermDefaults {
  static constexpr const char* kName = "shear_friction";
  static constexpr const char* kDoc = "friction of shear, with hysteresis";
  static constexpr const char* kReference = "Dahl 1968; Bliman and Sorine 1995; Miguel et al. 2013";
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 3;
  static constexpr int kMemory = 1;  // z, no unit
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"stress", "N/m", "largest shear force per width", 0.0, 0.0, 0.0, 100.0, Scale::kLinear, 0.5},
      Shape({"onset", "rad", "shear over which it builds up", 0.01, 0.01, 1e-4, 1.0, Scale::kLog,
             3.0},
            Meaning::kNumber, 0.002, 0.01, 0.05),
  }};
  using Element = ShearTriangle;

  static std::vector<Element> Elements(const TermContext& context) {
    return ShearTriangles(context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ShearFriction, T>& in,
                       ElementOutput<ShearFriction, T>* out) {
    const T turned = ShearStrain<T>(element, in.x) - ShearStrain<T>(element, in.start);
    out->memory[0] = SlideFriction<T>(out->memory[0], turned / in.parameter[1]);
    AddShearStress<T>(element, in.x, in.parameter[0] * out->memory[0], &out->force);
  }
};

}  // namespace clothfit
