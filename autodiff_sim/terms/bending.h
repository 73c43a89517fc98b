// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Bending between two triangles that share an edge, Bridson, Marino and Fedkiw 2003, sec. 4: the
// mode u of four particles that changes the dihedral angle theta and nothing else,
//   f_i = (-k_e |E|^2 / (|N1| + |N2|) sin(theta / 2) - k_d |E| dtheta/dt) dtheta/dx_i,
// their u_i being the angle's gradient with the sign of their theta. The factors of E and N are the
// rest shape's, so that the elastic part has an energy, 2 k_e |E|^2 / (|N1| + |N2|) (1 - cos(theta
// / 2)). On a grid k_e relates to the bending stiffness B of a plate, N m, by k_e = 4 B for bending
// along the warp or the weft, and k_e = 8/3 B along the bias of square cells.
#pragma once

#include <cmath>

#include "autodiff_sim/term.h"

namespace clothfit {

struct Bending {
  static constexpr const char* kName = "bending";
  static constexpr const char* kDoc =
      "resistance to folding between neighbouring triangles, with damping";
  static constexpr const char* kReference = "Bridson, Marino and Fedkiw 2003, sec. 4";
  static constexpr int kNodes = 4;
  static constexpr int kInputs = 0;
  static constexpr int kMemory = 0;
  static constexpr bool kUsesAcceleration = false;
  static constexpr bool kUsesDensity = false;
  static constexpr bool kUsesShrinkage = false;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"stiffness", "N m", "k_e of the four-particle bending mode", 2e-5, 0.0, 1e-8, 1e-1,
       Scale::kLog, 10.0},
      {"damping", "N s", "k_d of the four-particle bending mode", 3e-4, 0.0, 1e-10, 1e-2,
       Scale::kLog, 10.0},
  }};
  using Element = Hinge;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.hinges;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Bending, T>& in,
                       ElementOutput<Bending, T>* out) {
    using std::atan2;
    using std::sin;
    using std::sqrt;
    const Vector3<T> edge = in.x[3] - in.x[2];
    const Vector3<T> a = in.x[0] - in.x[2], b = in.x[0] - in.x[3];
    const Vector3<T> c = in.x[1] - in.x[3], d = in.x[1] - in.x[2];
    const Vector3<T> normal1 = a.cross(b), normal2 = c.cross(d);
    const T length = sqrt(edge.dot(edge));
    const T n1 = normal1.dot(normal1), n2 = normal2.dot(normal2);
    const T theta = atan2(normal1.cross(normal2).dot(edge) / length, normal1.dot(normal2));
    // The gradient of theta, Bridson et al. 2003, eq. for u_1 ... u_4.
    const T w1 = length / n1, w2 = length / n2;
    const T inverse = T(1.0) / (length * length);
    const T s1 = b.dot(edge) * inverse, s2 = c.dot(edge) * inverse;
    const T t1 = -a.dot(edge) * inverse, t2 = -d.dot(edge) * inverse;
    std::array<Vector3<T>, 4> u;
    T rate = T(0.0);
    for (int k = 0; k < 3; ++k) {
      const T g1 = w1 * normal1[k], g2 = w2 * normal2[k];
      u[0][k] = g1;
      u[1][k] = g2;
      u[2][k] = s1 * g1 + s2 * g2;
      u[3][k] = t1 * g1 + t2 * g2;
      for (int i = 0; i < 4; ++i) rate += u[i][k] * in.v[i][k];
    }
    const T moment =
        in.parameter[0] * element.shape * sin(theta * 0.5) - in.parameter[1] * element.edge * rate;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) out->force[i][k] += moment * u[i][k];
    }
  }
};

}  // namespace clothfit
