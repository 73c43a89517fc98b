// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Weight: f = s m g, with the particle's lumped mass m = areal density times area.
#pragma once

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct Gravity : TermDefaults {
  static constexpr const char* kName = "gravity";
  static constexpr const char* kDoc = "weight of the cloth in the recording's gravity";
  static constexpr const char* kReference = "Newton";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kUsesDensity = true;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 1> kParameters = {{
      {"scale", "1", "multiple of the recording's gravity", 1.0, 0.0, 0.0, 2.0, Scale::kLinear,
       0.01},
  }};

  struct Element {
    std::array<int, 1> nodes;
    double area;              // m^2
    Eigen::Vector3d gravity;  // m/s^2
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    for (int i = 0; i < context.mesh.num_particles(); ++i) {
      elements.push_back({{i}, context.topology.areas[i], context.world.gravity});
    }
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Gravity, T>& in,
                       ElementOutput<Gravity, T>* out) {
    const T mass = in.areal_density * element.area;
    for (int k = 0; k < 3; ++k) out->force[0][k] += in.parameter[0] * mass * element.gravity[k];
  }

  static double Energy(const Element& element, const ElementInput<Gravity, double>& in) {
    return -in.parameter[0] * in.areal_density * element.area * element.gravity.dot(in.x[0]);
  }
};

}  // namespace clothfit
