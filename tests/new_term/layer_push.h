// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A term that nobody needs, written as any other one: the force per area
//   f = pressure exp(-(z - height)^2 / (2 depth^2)) e_y.
// CMakeLists.txt beside it adds the one line that the list of terms takes.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct LayerPush : TermDefaults {
  static constexpr const char* kName = "layer_push";
  static constexpr const char* kDoc = "a push along y in a layer of heights";
  static constexpr const char* kReference = "an example";
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kPrefersAxes = true;
  static constexpr Work kWork = Work::kDrives;
  static constexpr std::array<Parameter, 3> kParameters = {{
      {"pressure", "Pa", "in the middle of the layer", 0.0, 0.0, -100.0, 100.0, Scale::kLinear,
       0.3},
      PlaceInWorld("height", Meaning::kPlaceZ, "of the layer's middle"),
      Shape({"depth", "m", "distance at which it has fallen to 61 %", 0.2, 0.2, 0.02, 10.0,
             Scale::kLog, 2.0},
            Meaning::kNumber, 0.1, 0.2),
  }};

  struct Element {
    std::array<int, 1> nodes;
    double area;  // m^2
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    for (int i = 0; i < context.mesh.num_particles(); ++i)
      elements.push_back({{i}, context.topology.areas[i]});
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<LayerPush, T>& in,
                       ElementOutput<LayerPush, T>* out) {
    using std::exp;
    const T away = (in.x[0].z() - in.parameter[1]) / in.parameter[2];
    out->force[0].y() += in.parameter[0] * element.area * exp(away * away * -0.5);
  }
};

}  // namespace clothfit
