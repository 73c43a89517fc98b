// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Structural and shear springs with damping along the spring, Hasler et al. 2007, sec. 3.1:
//   f = +-(k_s (|dx| - l0) / |dx| + k_d dx.dv / |dx|^2) dx.
// The parameters are per width of cloth, so that they do not change with the resolution:
// k_s = stiffness * weight and k_d = damping * weight, weight = width / length of the spring.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// m. The (u, v) that a cloth is given may be a little off its size at rest: see docs/model.md.
template <class T>
T RestLength(const Spring& spring, const std::array<T, 2>& shrinkage) {
  using std::sqrt;
  const T warp = 1.0 - shrinkage[0], weft = 1.0 - shrinkage[1];
  return spring.rest_length *
         sqrt(spring.warp_share * warp * warp + (1.0 - spring.warp_share) * weft * weft);
}

template <class T>
void AddSpringForce(const Spring& spring, const T& stiffness, const T& damping,
                    const std::array<T, 2>& shrinkage, const Vector3<T>& dx, const Vector3<T>& dv,
                    Vector3<T>* force_a, Vector3<T>* force_b) {
  using std::sqrt;
  const T length2 = dx.dot(dx);
  const T length = sqrt(length2);
  const T rest_length = RestLength<T>(spring, shrinkage);
  const T elastic = stiffness * ((length - rest_length) / length);
  const T viscous = damping * (dx.dot(dv) / length2);
  const T tension = (elastic + viscous) * spring.weight;
  for (int k = 0; k < 3; ++k) {
    const T f = tension * dx[k];
    (*force_a)[k] += f;
    (*force_b)[k] -= f;
  }
}

// J.
inline double SpringEnergy(const Spring& spring, double stiffness,
                           const std::array<double, 2>& shrinkage, const Eigen::Vector3d& dx) {
  const double extension = dx.norm() - RestLength<double>(spring, shrinkage);
  return 0.5 * stiffness * spring.weight * extension * extension;
}

struct StretchSpring : TermDefaults {
  static constexpr const char* kName = "stretch";
  static constexpr const char* kDoc = "structural springs along warp and weft, with damping";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3.1, f_spring";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 2;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N/m", "membrane stiffness along warp and weft", 1000.0, 0.0, 1.0, 1e5,
            Scale::kLog, 10.0}),
      Free({"damping", "N s/m", "damping of stretching", 3.0, 0.0, 1e-6, 100.0, Scale::kLog, 10.0}),
  }};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.structural;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StretchSpring, T>& in,
                       ElementOutput<StretchSpring, T>* out) {
    AddSpringForce<T>(element, in.parameter[0], in.parameter[1], in.shrinkage, in.x[1] - in.x[0],
                      in.v[1] - in.v[0], &out->force[0], &out->force[1]);
  }

  static double Energy(const Element& element, const ElementInput<StretchSpring, double>& in) {
    return SpringEnergy(element, in.parameter[0], in.shrinkage, in.x[1] - in.x[0]);
  }
};

struct ShearSpring : TermDefaults {
  static constexpr const char* kName = "shear";
  static constexpr const char* kDoc = "springs along the bias, with damping";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3.1, f_spring";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 2;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N/m", "shear modulus times thickness", 20.0, 0.0, 0.1, 1e4, Scale::kLog,
            10.0}),
      Free({"damping", "N s/m", "damping of shearing", 3.0, 0.0, 1e-6, 100.0, Scale::kLog, 10.0}),
  }};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.shear;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ShearSpring, T>& in,
                       ElementOutput<ShearSpring, T>* out) {
    AddSpringForce<T>(element, in.parameter[0], in.parameter[1], in.shrinkage, in.x[1] - in.x[0],
                      in.v[1] - in.v[0], &out->force[0], &out->force[1]);
  }

  static double Energy(const Element& element, const ElementInput<ShearSpring, double>& in) {
    return SpringEnergy(element, in.parameter[0], in.shrinkage, in.x[1] - in.x[0]);
  }
};

}  // namespace clothfit
