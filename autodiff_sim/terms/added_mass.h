// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Air that moves along with a triangle: an inertia without weight. A plate in ideal fluid carries
// the kinetic energy of the fluid around it along its normal alone (Lamb 1932, Hydrodynamics, ch.
// VI: impulse of a solid in a fluid); in a viscous one its sides drag air along them, too
// (Batchelor 1967, An Introduction to Fluid Dynamics, sec. 4.3). Per triangle of rest area A and
// unit normal n,
//   T = 1/2 A (m_n s^2 + m_t (v . v - s^2)),  s = n . v,  v the mean velocity of its corners,
// and Lagrange's equations give the force on each corner, with m = m_n - m_t and a = dv/dt,
//   f_i = -d/dt (dT/dv_i) + dT/dx_i = -A (m ((ds/dt n + s dn/dt) / 3 - s ds/dx_i) + m_t a / 3).
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
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"normal", "kg/m^2", "air moved along the normal, per area of cloth", 0.0, 0.0, 0.0, 1.0,
       Scale::kLinear, 0.05},
      {"tangential", "kg/m^2", "air moved along the surface, per area of cloth", 0.0, 0.0, 0.0, 1.0,
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
    const T mass = (in.parameter[0] - in.parameter[1]) * element.area;
    const T any_way = in.parameter[1] * element.area * T(kThird);
    const Vector3<T> momentum_rate = (n * s_rate + n_rate * s) * T(kThird);
    out->force[0] -= (momentum_rate + (gradient1 + gradient2) * s) * mass + acceleration * any_way;
    out->force[1] -= (momentum_rate - gradient1 * s) * mass + acceleration * any_way;
    out->force[2] -= (momentum_rate - gradient2 * s) * mass + acceleration * any_way;
  }
};

}  // namespace clothfit
