// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Wind: air that moves evenly. It is a part of the air drag, whose law and coefficients act on the
// velocity relative to the air,
//   f = f_drag(v - w) - f_drag(v),
// so that the term is exactly nothing in still air, and nothing on a cloth without air drag.
#pragma once

#include "autodiff_sim/terms/air_drag.h"

namespace clothfit {

struct UniformWind : TermDefaults {
  static constexpr const char* kName = "wind";
  static constexpr const char* kDoc = "air that moves evenly, felt through the air drag";
  static constexpr const char* kReference = "Bhat et al. 2003, drag in moving air";
  static constexpr Work kWork = Work::kDrives;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 3> kParameters = {{
      {"x", "m/s", "velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorX},
      {"y", "m/s", "velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorY},
      {"z", "m/s", "velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorZ},
  }};
  static constexpr std::array<const char*, 3> kReads = {"air_drag.normal", "air_drag.saturation",
                                                        "air_drag.tangential"};

  using Element = AirDrag::Element;
  static std::vector<Element> Elements(const TermContext& context) {
    return AirDrag::Elements(context);
  }

  template <class T>
  static void AddForce(const Element&, const ElementInput<UniformWind, T>& in,
                       ElementOutput<UniformWind, T>* out) {
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(1.0 / 3.0);
    const Vector3<T> wind(in.parameter[0], in.parameter[1], in.parameter[2]);
    const Vector3<T> force =
        AirDragForce<T>(in.x, velocity - wind, in.read) - AirDragForce<T>(in.x, velocity, in.read);
    for (Vector3<T>& corner : out->force) corner += force;
  }

  template <class Sink>
  static void AddJacobian(const Element&, const ElementInput<UniformWind, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    const Eigen::Vector3d velocity = (in.v[0] + in.v[1] + in.v[2]) / 3.0;
    const Eigen::Vector3d wind(in.parameter[0], in.parameter[1], in.parameter[2]);
    AddAirDragJacobian(in.x, velocity - wind, in.read, 1.0, weights, sink);
    AddAirDragJacobian(in.x, velocity, in.read, -1.0, weights, sink);
  }
};

}  // namespace clothfit
