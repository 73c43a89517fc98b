// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Air that moves along with a triangle: an inertia along its normal only. A plate in ideal fluid
// carries the kinetic energy of the fluid around it (Lamb 1932, Hydrodynamics, ch. VI: impulse of a
// solid in a fluid), here, per triangle of rest area A and unit normal n,
//   T = 1/2 m A s^2,  s = n . v,  v the mean velocity of its corners,
// and Lagrange's equations give the force on each corner,
//   f_i = -d/dt (dT/dv_i) + dT/dx_i = -m A ((ds/dt n + s dn/dt) / 3 - s ds/dx_i).
#pragma once

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct AddedMass : TermDefaults {
  static constexpr const char* kName = "added_mass";
  static constexpr const char* kDoc = "inertia of the air that moves along with the surface";
  static constexpr const char* kReference = "Lamb 1932, ch. VI, kinetic energy of a moved fluid";
  static constexpr int kNodes = 3;
  static constexpr bool kUsesAcceleration = true;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 1> kParameters = {{
      {"normal", "kg/m^2", "air moved along the normal, per area of cloth", 0.0, 0.0, 0.0, 1.0,
       Scale::kLinear, 0.05},
  }};

  using Element = RestTriangle;
  static std::vector<Element> Elements(const TermContext& context) {
    return RestTriangles(context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<AddedMass, T>& in,
                       ElementOutput<AddedMass, T>* out) {
    using std::sqrt;
    constexpr double kThird = 1.0 / 3.0;
    const Vector3<T> side1 = in.x[1] - in.x[0], side2 = in.x[2] - in.x[0];
    const Vector3<T> turn1 = in.v[1] - in.v[0], turn2 = in.v[2] - in.v[0];
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(kThird);
    const Vector3<T> acceleration = (in.a[0] + in.a[1] + in.a[2]) * T(kThird);
    const Vector3<T> across = side1.cross(side2);
    const T per_area = T(1.0) / sqrt(across.dot(across));
    const Vector3<T> n = across * per_area;
    // dn/dt: the part across n of d(side1 x side2)/dt, over twice the area.
    const Vector3<T> across_rate = (turn1.cross(side2) + side1.cross(turn2)) * per_area;
    const Vector3<T> n_rate = across_rate - n * n.dot(across_rate);
    const T s = n.dot(velocity);
    const T s_rate = n.dot(acceleration) + n_rate.dot(velocity);
    // ds/dx_i at fixed velocity.
    const Vector3<T> along = velocity - n * s;
    const Vector3<T> gradient1 = side2.cross(along) * per_area;
    const Vector3<T> gradient2 = along.cross(side1) * per_area;
    const T mass = in.parameter[0] * element.area;
    const Vector3<T> momentum_rate = (n * s_rate + n_rate * s) * T(kThird);
    out->force[0] -= (momentum_rate + (gradient1 + gradient2) * s) * mass;
    out->force[1] -= (momentum_rate - gradient1 * s) * mass;
    out->force[2] -= (momentum_rate - gradient2 * s) * mass;
  }
};

}  // namespace clothfit
