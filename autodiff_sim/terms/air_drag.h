// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Air resistance of a triangle, Bhat et al. 2003 as in Hasler et al. 2007, sec. 3.1:
//   f = -A (k_n |v_n|^2 / (1 + k_f |v_n|^2) v_n / |v_n| + k_t v_t),
// v the triangle's mean velocity relative to the air, which is still, split along and across its
// normal; each corner gets a third.
#pragma once

#include <cmath>

#include "autodiff_sim/term/element_jacobian.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// The force on each corner of a triangle at x whose mean velocity relative to the air is `velocity`
// (m/s); k: k_n, k_f and k_t.
template <class T>
Vector3<T> AirDragForce(const std::array<Vector3<T>, 3>& x, const Vector3<T>& velocity,
                        const std::array<T, 3>& k) {
  using std::abs;
  using std::sqrt;
  const Vector3<T> side1 = x[1] - x[0], side2 = x[2] - x[0];
  const Vector3<T> normal = side1.cross(side2);
  const T twice_area = sqrt(normal.dot(normal));
  const T speed = velocity.dot(normal) / twice_area;  // along the unit normal
  const T quadratic = k[0] * abs(speed) / (T(1.0) + k[1] * speed * speed);
  // f = -A (k_t v + (quadratic - k_t) speed n), a third to each corner.
  const T along_normal = (quadratic - k[2]) * speed / twice_area;
  const T share = twice_area * (-1.0 / 6.0);
  Vector3<T> force;
  for (int i = 0; i < 3; ++i) force[i] = share * (k[2] * velocity[i] + along_normal * normal[i]);
  return force;
}

// `sign` times the derivatives of that force by the corners' places and, through the mean velocity,
// by their velocities. With N the normal, s the speed along it and P(s) = (quadratic - k_t) s the
// force is -(k_t |N| v + P N) / 6.
template <class Sink>
void AddAirDragJacobian(const std::array<Eigen::Vector3d, 3>& x, const Eigen::Vector3d& velocity,
                        const std::array<double, 3>& k, double sign, const JacobianWeights& weights,
                        const Sink& sink) {
  const Eigen::Vector3d side1 = x[1] - x[0], side2 = x[2] - x[0];
  const Eigen::Vector3d normal = side1.cross(side2);
  const double twice_area = normal.norm();
  const Eigen::Vector3d unit = normal / twice_area;
  const double speed = velocity.dot(unit), share = 1.0 / (1.0 + k[1] * speed * speed);
  const double push = (k[0] * std::abs(speed) * share - k[2]) * speed;
  const double slope = 2.0 * k[0] * std::abs(speed) * share * share - k[2];
  const double scale = -sign / 6.0;
  const double by_x = scale * weights.x, by_v = scale * weights.v / 3.0;
  const Eigen::Vector3d along = velocity - speed * unit;
  for (int p = 0; p < 3; ++p) {
    Eigen::Vector3d by_normal = k[2] * velocity[p] * unit + slope * unit[p] * along;
    by_normal[p] += push;
    by_normal *= by_x;
    Eigen::Vector3d by_velocity = (by_v * slope * normal[p]) * unit;
    by_velocity[p] += by_v * k[2] * twice_area;
    const Eigen::Vector3d by_side1 = side2.cross(by_normal), by_side2 = by_normal.cross(side1);
    const JacobianRow rows[3] = {JacobianRow(by_velocity - by_side1 - by_side2),
                                 JacobianRow(by_velocity + by_side1),
                                 JacobianRow(by_velocity + by_side2)};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) sink(a, b, p, rows[b]);
    }
  }
}

struct AirDrag : TermDefaults {
  static constexpr const char* kName = "air_drag";
  static constexpr const char* kDoc = "resistance of still air, normal and tangential";
  static constexpr const char* kReference = "Bhat et al. 2003; Hasler et al. 2007, sec. 3.1, f_air";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 3> kParameters = {{
      Free({"normal", "kg/m^3", "k_n, quadratic drag along the normal", 0.6, 0.0, 1e-3, 20.0,
            Scale::kLog, 3.0}),
      Free({"saturation", "s^2/m^2", "k_f, weakens the quadratic drag at speed", 2.0, 0.0, 0.0,
            30.0, Scale::kLinear, 3.0}),
      Free({"tangential", "kg/(m^2 s)", "k_t, linear drag along the surface", 0.02, 0.0, 1e-5, 2.0,
            Scale::kLog, 10.0}),
  }};

  struct Element {
    std::array<int, 3> nodes;
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    for (const std::array<int, 3>& triangle : context.mesh.triangles)
      elements.push_back({triangle});
    return elements;
  }

  template <class T>
  static void AddForce(const Element&, const ElementInput<AirDrag, T>& in,
                       ElementOutput<AirDrag, T>* out) {
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(1.0 / 3.0);
    const Vector3<T> force = AirDragForce<T>(in.x, velocity, in.parameter);
    for (Vector3<T>& corner : out->force) corner += force;
  }

  template <class Sink>
  static void AddJacobian(const Element&, const ElementInput<AirDrag, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    AddAirDragJacobian(in.x, (in.v[0] + in.v[1] + in.v[2]) / 3.0, in.parameter, 1.0, weights, sink);
  }
};

}  // namespace clothfit
