// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Springs along warp and weft with damping along them, Hasler et al. 2007, sec. 3.1:
//   f = +-(k_s (|dx| - l0) / |dx| + k_d dx.dv / |dx|^2) dx,
// whose compression is limited by buckling below the mesh (term/buckling.h) unless the mesh says
// otherwise. The parameters are per width of cloth, so that they do not change with the resolution:
// k_s = stiffness * weight and k_d = damping * weight, weight = width / length of the spring.
#pragma once

#include <cmath>

#include "autodiff_sim/term/buckling.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// What springs are made of: stiffness (N/m), damping (N s/m), and bending.stiffness (N m), on which
// hangs where they buckle.
template <class T>
struct SpringLaw {
  T stiffness, damping, bending;
};

// m. The (u, v) that a cloth is given may be a little off its size at rest: see docs/model.md.
template <class T>
T RestLength(const Spring& spring, const std::array<T, 2>& shrinkage) {
  using std::sqrt;
  const T warp = 1.0 - shrinkage[0], weft = 1.0 - shrinkage[1];
  return spring.rest_length *
         sqrt(spring.warp_share * warp * warp + (1.0 - spring.warp_share) * weft * weft);
}

// Tension per width, N/m, at a strain and its rate (1/s).
template <class T>
T SpringTension(const Spring& spring, const SpringLaw<T>& law, const T& strain, const T& rate) {
  const T viscous = law.damping * rate;
  if (spring.buckling_length == 0.0 || Value(law.stiffness) <= 0.0)
    return law.stiffness * strain + viscous;
  const T load = BucklingLoad<T>(law.bending, law.stiffness, spring.buckling_length);
  return BuckledTension<T>(law.stiffness, load, strain, viscous);
}

// The force of a spring of this law less that of one of another, if there is another.
template <class T>
void AddSpringForce(const Spring& spring, const SpringLaw<T>& law, const SpringLaw<T>* less,
                    const std::array<T, 2>& shrinkage, const std::array<Vector3<T>, 2>& x,
                    const std::array<Vector3<T>, 2>& v, std::array<Vector3<T>, 2>* force) {
  using std::sqrt;
  const Vector3<T> dx = x[1] - x[0];
  const T length = sqrt(dx.dot(dx)), rest_length = RestLength<T>(spring, shrinkage);
  const T strain = length / rest_length - 1.0;
  const T rate = dx.dot(v[1] - v[0]) / (length * rest_length);
  T tension = SpringTension<T>(spring, law, strain, rate);
  if (less != nullptr) tension -= SpringTension<T>(spring, *less, strain, rate);
  const T pull = tension * (rest_length * spring.weight) / length;
  for (int k = 0; k < 3; ++k) {
    const T f = pull * dx[k];
    (*force)[0][k] += f;
    (*force)[1][k] -= f;
  }
}

// J.
inline double SpringEnergy(const Spring& spring, const SpringLaw<double>& law,
                           const std::array<double, 2>& shrinkage, const Eigen::Vector3d& dx) {
  const double rest_length = RestLength<double>(spring, shrinkage);
  const double strain = dx.norm() / rest_length - 1.0;
  const double area = spring.weight * rest_length * rest_length;
  if (spring.buckling_length == 0.0 || law.stiffness <= 0.0)
    return 0.5 * law.stiffness * strain * strain * area;
  const double load = BucklingLoad(law.bending, law.stiffness, spring.buckling_length);
  return BuckledEnergy(law.stiffness, load, strain) * area;
}

struct StretchSpring : TermDefaults {
  static constexpr const char* kName = "stretch";
  static constexpr const char* kDoc = "springs along warp and weft, with damping";
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
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.structural;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StretchSpring, T>& in,
                       ElementOutput<StretchSpring, T>* out) {
    const SpringLaw<T> law = {in.parameter[0], in.parameter[1], in.read[0]};
    AddSpringForce<T>(element, law, nullptr, in.shrinkage, in.x, in.v, &out->force);
  }

  static double Energy(const Element& element, const ElementInput<StretchSpring, double>& in) {
    return SpringEnergy(element, {in.parameter[0], in.parameter[1], in.read[0]}, in.shrinkage,
                        in.x[1] - in.x[0]);
  }
};

}  // namespace clothfit
