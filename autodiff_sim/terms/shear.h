// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Shearing of the cloth: springs along the bias, Hasler et al. 2007, sec. 3.1. Their compression is
// limited by buckling like that of the springs along the threads (spring.h).
#pragma once

#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct Shear : TermDefaults {
  static constexpr const char* kName = "shear";
  static constexpr const char* kDoc = "shearing, with damping";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3.1, f_spring";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 4;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  // The longest wave of shear in a metre of cloth (50 N/m, 0.2 kg/m^2) is damped critically by
  // 2 (1 m / pi) sqrt(50 * 0.2) = 2 N s/m; ten times that moves hardly differently from more, with
  // which Newton's method takes several times as long.
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N/m", "shear modulus times thickness", 20.0, 0.0, 0.1, 1e4, Scale::kLog,
            10.0}),
      Free({"damping", "N s/m", "damping of shearing", 3.0, 0.0, 1e-6, 20.0, Scale::kLog, 10.0}),
  }};
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  // The springs of nodes 0 and 1 and of nodes 2 and 3. Where there is one, its last node again.
  struct Element {
    std::array<int, 4> nodes;
    int springs;
    std::array<Spring, 2> bias;
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Shear, T>& in,
                       ElementOutput<Shear, T>* out) {
    const SpringLaw<T> law = {in.parameter[0], in.parameter[1], in.read[0]};
    for (int i = 0; i < element.springs; ++i) {
      AddSpringForce<T>(element.bias[i], law, in.shrinkage, 2 * i, 2 * i + 1, in.x, in.v,
                        &out->force);
    }
  }

  template <class Sink>
  static void AddJacobian(const Element& element, const ElementInput<Shear, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    for (int i = 0; i < element.springs; ++i) {
      AddSpringJacobian(element.bias[i], {in.parameter[0], in.parameter[1], in.read[0]},
                        in.shrinkage, 2 * i, 2 * i + 1, in.x, in.v, weights, sink);
    }
  }

  static double Energy(const Element& element, const ElementInput<Shear, double>& in);
};

}  // namespace clothfit
