// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Bending between two triangles that share an edge, Bridson, Marino and Fedkiw 2003, sec. 4: the
// mode u of four particles that changes the dihedral angle theta and nothing else,
//   f_i = -|E|^2 / (|N1| + |N2|) (k_e sin(theta / 2) + k_d / 2 dtheta/dt) dtheta/dx_i,
// their u_i being the angle's gradient with the sign of their theta. The factors of E and N are the
// rest shape's, so that the elastic part has an energy, 2 k_e |E|^2 / (|N1| + |N2|) (1 - cos(theta
// / 2)). Hinges of a grid count by shares (mesh/cloth_mesh.h), so that k_e is four times the
// bending stiffness B of a plate, N m, in every direction. Their damping, k_d |E| dtheta/dt with
// k_d in N s, makes a fold's retardation time go with the mesh's spacing. This one is k_d / k_e on
// every mesh, as that of stretch and of shear.
#pragma once

#include "autodiff_sim/term/fold_angle.h"
#include "autodiff_sim/term/fold_jacobian.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

struct Bending : TermDefaults {
  static constexpr const char* kName = "bending";
  static constexpr const char* kDoc =
      "resistance to folding between neighbouring triangles, with damping";
  static constexpr const char* kReference = "Bridson, Marino and Fedkiw 2003, sec. 4";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N m", "k_e of the four-particle bending mode", 2e-5, 0.0, 1e-8, 1e-1,
            Scale::kLog, 10.0}),
      Free({"damping", "N m s", "k_d of the four-particle bending mode", 5e-5, 0.0, 1e-11, 1e-3,
            Scale::kLog, 10.0}),
  }};
  using Element = Hinge;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.hinges;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Bending, T>& in,
                       ElementOutput<Bending, T>* out) {
    const Fold<T> fold = MakeFold<T>(in.x);
    const std::array<Vector3<T>, 4> u = FlatteningMode<T>(fold);
    T rate = T(0.0);
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 4; ++i) rate += u[i][k] * in.v[i][k];
    }
    const T moment =
        element.shape * (in.parameter[0] * HalveAngle<T>(fold).sine - 0.5 * in.parameter[1] * rate);
    AddFlatteningMoment<T>(moment, u, &out->force);
  }

  // f_i = m u_i with m = k sin(theta / 2) - c u.v, so that -dm = (k/2 cos(theta / 2) u + c
  // d(u.v)).dx
  // + c u.dv.
  template <class Sink>
  static void AddJacobian(const Element& element, const ElementInput<Bending, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    const Fold<double> fold = MakeFold<double>(in.x);
    const FoldJacobian::Vectors u = FlatteningMode<double>(fold);
    const FoldJacobian jacobian(fold, u);
    const HalfAngle<double> half = HalveAngle<double>(fold);
    const double elastic = in.parameter[0] * element.shape;
    const double viscous = 0.5 * in.parameter[1] * element.shape;
    FoldJacobian::Vectors fall = jacobian.DerivativeOfRate(in.v);  // -dm/dx, weighted
    double rate = 0.0;
    for (int i = 0; i < 4; ++i) {
      rate += u[i].dot(in.v[i]);
      fall[i] = (weights.x * 0.5 * elastic * half.cosine + weights.v * viscous) * u[i] +
                weights.x * viscous * fall[i];
    }
    jacobian.Add(weights.x * (elastic * half.sine - viscous * rate), fall, sink);
  }

  static double Energy(const Element& element, const ElementInput<Bending, double>& in) {
    const HalfAngle<double> half = HalveAngle<double>(MakeFold<double>(in.x));
    return 2.0 * in.parameter[0] * element.shape * (1.0 - half.cosine);
  }
};

}  // namespace clothfit
