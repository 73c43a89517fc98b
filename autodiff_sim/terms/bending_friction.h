// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction of the threads against each other where the cloth bends: Dahl's law on the curvature,
//   moment per width = limit * z,  dz = (d kappa - z |d kappa|) / onset,
// kappa = 2 theta / (h1 + h2) the curvature across an edge, theta the angle of its fold and h1, h2
// the heights of the two triangles. It stays when the motion stops: folds remain.
#pragma once

#include <cmath>

#include "autodiff_sim/term/dahl_friction.h"
#include "autodiff_sim/term/fold_angle.h"

namespace clothfit {

struct BendingFriction : TermDefaults {
  static constexpr const char* kName = "bending_friction";
  static constexpr const char* kDoc = "friction of bending, with hysteresis";
  static constexpr const char* kReference = "Dahl 1968; Bliman and Sorine 1995; Miguel et al. 2013";
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 4;
  static constexpr int kMemory = 1;  // z, no unit
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"moment", "N", "largest moment per width", 0.0, 0.0, 0.0, 0.1, Scale::kLinear, 5e-4},
      Shape({"onset", "1/m", "curvature over which it builds up", 10.0, 10.0, 0.1, 1e3, Scale::kLog,
             3.0},
            Meaning::kNumber, 2.0, 10.0, 50.0),
  }};
  using Element = Hinge;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.hinges;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<BendingFriction, T>& in,
                       ElementOutput<BendingFriction, T>* out) {
    const Fold<T> fold = MakeFold<T>(in.x);
    T turned = FoldAngle<T>(fold) - FoldAngle<T>(MakeFold<T>(in.start));
    if (Value(turned) > M_PI) turned -= T(2.0 * M_PI);
    if (Value(turned) < -M_PI) turned += T(2.0 * M_PI);
    // 1 / (h1 + h2), on a grid 4/3 of it: there the sides of cells fold by 3/4 of the curvature.
    const T slide = turned * (2.0 * element.shape / element.width) / in.parameter[1];
    out->memory[0] = SlideFriction<T>(out->memory[0], slide);
    const T moment = in.parameter[0] * element.width * out->memory[0];
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
