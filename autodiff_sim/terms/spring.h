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

#include "autodiff_sim/base/dual.h"
#include "autodiff_sim/term/buckling.h"
#include "autodiff_sim/term/element_jacobian.h"
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

template <class T>
bool Buckles(const Spring& spring, const SpringLaw<T>& law) {
  return spring.buckling_length > 0.0 && Value(law.stiffness) > 0.0;
}

// N/m, per width of cloth: the material's tension without wrinkles. rest_length and length in m;
// rate: dx.dv (m^2/s) from one end to the other.
template <class T>
T PlainTension(const SpringLaw<T>& law, const T& rest_length, const T& length, const T& rate) {
  return law.stiffness * (length / rest_length - 1.0) + law.damping * rate / (length * rest_length);
}

// N/m: the spring's tension over its length. With dx (m) and dv (m/s) from one end to the other,
// length2 is dx.dx (m^2) and rate dx.dv (m^2/s).
template <class T>
T SpringPull(const Spring& spring, const SpringLaw<T>& law, const std::array<T, 2>& shrinkage,
             const T& length2, const T& rate) {
  using std::sqrt;
  const T length = sqrt(length2);
  const T rest_length = RestLength<T>(spring, shrinkage);
  T tension = PlainTension<T>(law, rest_length, length, rate);
  if (Buckles(spring, law)) {
    tension = BuckledTension<T>(
        tension, BucklingLoad<T>(law.bending, law.stiffness, spring.buckling_length));
  }
  return tension * (rest_length * spring.weight) / length;
}

template <class T>
void AddPull(const T& pull, const Vector3<T>& dx, Vector3<T>* force_a, Vector3<T>* force_b) {
  for (int k = 0; k < 3; ++k) {
    const T f = pull * dx[k];
    (*force_a)[k] += f;
    (*force_b)[k] -= f;
  }
}

// Adds the force of a spring from node a to node b of an element.
template <class T, std::size_t kNodes>
void AddSpringForce(const Spring& spring, const SpringLaw<T>& law,
                    const std::array<T, 2>& shrinkage, int a, int b,
                    const std::array<Vector3<T>, kNodes>& x,
                    const std::array<Vector3<T>, kNodes>& v,
                    std::array<Vector3<T>, kNodes>* force) {
  const Vector3<T> dx = x[b] - x[a];
  const T length2 = dx.dot(dx), rate = dx.dot(v[b] - v[a]);
  AddPull<T>(SpringPull<T>(spring, law, shrinkage, length2, rate), dx, &(*force)[a], &(*force)[b]);
}

// Its derivatives, term/element_jacobian.h: with the pull P(dx.dx, dx.dv) of node a along dx,
//   d(P dx) = P d(dx) + dx (2 P_1 dx + P_2 dv).d(dx) + P_2 dx dx.d(dv).
template <std::size_t kNodes, class Sink>
void AddSpringJacobian(const Spring& spring, const SpringLaw<double>& law,
                       const std::array<double, 2>& shrinkage, int a, int b,
                       const std::array<Eigen::Vector3d, kNodes>& x,
                       const std::array<Eigen::Vector3d, kNodes>& v, const JacobianWeights& weights,
                       const Sink& sink) {
  using T = Dual<WholeRegisters(2)>;
  const Eigen::Vector3d dx = x[b] - x[a], dv = v[b] - v[a];
  T length2(dx.squaredNorm()), rate(dx.dot(dv));
  length2.SetDerivative(0, 1.0);
  rate.SetDerivative(1, 1.0);
  const SpringLaw<T> constants = {T(law.stiffness), T(law.damping), T(law.bending)};
  const T pull =
      SpringPull<T>(spring, constants, {T(shrinkage[0]), T(shrinkage[1])}, length2, rate);
  const double by_rate = pull.derivative(1), kept = weights.x * pull.a;
  const JacobianRow gradient = JacobianRow(
      (2.0 * weights.x * pull.derivative(0) + weights.v * by_rate) * dx + weights.x * by_rate * dv);
  const JacobianRow identity[3] = {{kept, 0, 0}, {0, kept, 0}, {0, 0, kept}};
  for (int p = 0; p < 3; ++p) AddPairRow(a, b, p, identity[p] + dx[p] * gradient, sink);
}

// Adds what a spring gains where its stiffness is multiplied by 1 + extra, without damping.
template <class T>
void AddExtraSpringForce(const Spring& spring, const T& stiffness, const T& extra, const T& bending,
                         const std::array<T, 2>& shrinkage, const std::array<Vector3<T>, 2>& x,
                         std::array<Vector3<T>, 2>* force) {
  const Vector3<T> dx = x[1] - x[0];
  const T length2 = dx.dot(dx);
  const auto pull = [&](const T& k) {
    return SpringPull<T>(spring, {k, T(0.0), bending}, shrinkage, length2, T(0.0));
  };
  const bool buckles = Buckles<T>(spring, {stiffness, T(0.0), bending});
  AddPull<T>(
      buckles ? T(pull(stiffness * (1.0 + extra)) - pull(stiffness)) : pull(stiffness * extra), dx,
      &(*force)[0], &(*force)[1]);
}

// J.
inline double SpringEnergy(const Spring& spring, const SpringLaw<double>& law,
                           const std::array<double, 2>& shrinkage, const Eigen::Vector3d& dx) {
  const double rest_length = RestLength<double>(spring, shrinkage);
  const double strain = dx.norm() / rest_length - 1.0;
  const double area = spring.weight * rest_length * rest_length;
  if (!Buckles(spring, law)) return 0.5 * law.stiffness * strain * strain * area;
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
    AddSpringForce<T>(element, {in.parameter[0], in.parameter[1], in.read[0]}, in.shrinkage, 0, 1,
                      in.x, in.v, &out->force);
  }

  template <class Sink>
  static void AddJacobian(const Element& element, const ElementInput<StretchSpring, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    AddSpringJacobian(element, {in.parameter[0], in.parameter[1], in.read[0]}, in.shrinkage, 0, 1,
                      in.x, in.v, weights, sink);
  }

  static double Energy(const Element& element, const ElementInput<StretchSpring, double>& in) {
    return SpringEnergy(element, {in.parameter[0], in.parameter[1], in.read[0]}, in.shrinkage,
                        in.x[1] - in.x[0]);
  }
};

}  // namespace clothfit
