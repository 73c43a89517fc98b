// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Gravity that is not quite where the recording has it: turned about two axes across it, which are
// x and y where it is along -z. The term is the difference that makes, f = s m (R g - g).
#pragma once

#include "autodiff_sim/term/term.h"
#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {

struct GravityTilt : TermDefaults {
  static constexpr const char* kName = "gravity_tilt";
  static constexpr const char* kDoc = "gravity turned away from the recording's";
  static constexpr const char* kReference = "Newton";
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kUsesDensity = true;
  static constexpr bool kPrefersAxes = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"angle_1", "rad", "about x where gravity is along -z", 0.0, 0.0, -0.5, 0.5, Scale::kLinear,
       0.01},
      {"angle_2", "rad", "about y where gravity is along -z", 0.0, 0.0, -0.5, 0.5, Scale::kLinear,
       0.01},
  }};
  static constexpr std::array<const char*, 1> kReads = {"gravity.scale"};

  struct Element {
    std::array<int, 1> nodes;
    double area;     // m^2
    double gravity;  // m/s^2
    DownFrame frame;
  };
  static std::vector<Element> Elements(const TermContext& context) {
    const Eigen::Vector3d& gravity = context.world.gravity;
    std::vector<Element> elements;
    for (int i = 0; i < context.mesh.num_particles(); ++i)
      elements.push_back({{i}, context.topology.areas[i], gravity.norm(), MakeDownFrame(gravity)});
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<GravityTilt, T>& in,
                       ElementOutput<GravityTilt, T>* out) {
    const T weight = in.read[0] * in.areal_density * (element.area * element.gravity);
    const Vector3<T> down = TiltedDown<T>(element.frame, in.parameter[0], in.parameter[1]);
    for (int k = 0; k < 3; ++k) out->force[0][k] += weight * (down[k] - element.frame.down[k]);
  }
};

}  // namespace clothfit
