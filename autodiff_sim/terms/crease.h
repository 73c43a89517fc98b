// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A crease: a rest curvature across a straight line in the cloth,
//   kappa(s) = curvature / cosh^2(s / width),
// s the distance from the line. The cloth at rest then has the height Z, Z'' = kappa,
//   Z(s) = curvature width^2 log cosh(s / width),
// and each fold the angle theta_0 that this height gives it; bending resists theta - theta_0 in
// place of theta (rest angles as in Grinspun et al. 2003, Discrete shells). All the crease turns by
// is the angle 2 curvature width, on any mesh, finer or coarser than the crease is wide.
#pragma once

#include <cmath>

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/term/fold_angle.h"

namespace clothfit {

// log cosh a, for any size of a.
template <class T>
T LogCosh(const T& a) {
  using std::exp;
  using std::log;
  const T size = Value(a) < 0.0 ? T(-a) : a;
  return size + log(1.0 + exp(-2.0 * size)) - M_LN2;
}

struct Crease : TermDefaults {
  static constexpr const char* kName = "crease";
  static constexpr const char* kDoc = "rest curvature across a straight line in the cloth";
  static constexpr const char* kReference = "rest angles as in Grinspun et al. 2003";
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 4> kParameters = {{
      {"curvature", "1/m", "on the line, positive where the sides rise along the normal", 0.0, 0.0,
       -500.0, 500.0, Scale::kLinear, 20.0},
      kLineAngle,
      kLineOffset,
      Shape({"width", "m", "distance at which the curvature has fallen to 42 %", 0.01, 0.01, 1e-4,
             1.0, Scale::kLog, 2.0},
            Meaning::kClothDistance, 0.02, 0.1),
  }};
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};

  struct Element {
    std::array<int, 4> nodes;
    double shape;                                // Hinge::shape
    std::array<Eigen::Vector2d, 4> from_middle;  // m, (u, v) from the cloth's middle
    std::array<double, 4> angle_of_height;       // rad/m, of the flat cloth's fold, by the heights
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Crease, T>& in,
                       ElementOutput<Crease, T>* out) {
    using std::cos;
    using std::sin;
    const std::array<T, 4>& p = in.parameter;
    T rest_angle = T(0.0);
    for (int i = 0; i < kNodes; ++i) {
      const T s = DistanceToLine<T>(element.from_middle[i], p[1], p[2]);
      const T height = p[0] * p[3] * p[3] * LogCosh<T>(s / p[3]);
      rest_angle += element.angle_of_height[i] * height;
    }
    const Fold<T> fold = MakeFold<T>(in.x);
    const HalfAngle<T> half = HalveAngle<T>(fold);
    const T rest = rest_angle * 0.5;
    // sin((theta - rest angle) / 2) - sin(theta / 2)
    const T difference = half.sine * (cos(rest) - 1.0) - half.cosine * sin(rest);
    const T moment = in.read[0] * element.shape * difference;
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
