// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Shearing of the cloth: springs along the bias, Hasler et al. 2007, sec. 3.1. What limits their
// compression is buckling below the mesh (term/buckling.h), of the two that cross in a cell
// together: with the strains e1 and e2, m = (e1 + e2) / 2 and d = (e1 - e2) / 2 the energy per area
//   k (e1^2 + e2^2) / 2 = k m^2 + k d^2
// is relaxed in m alone. Shear without a change of area has m = 0, so that taut cloth resists it
// with all of its stiffness; of all convex laws that leave it that, this one resists a fold along
// a bias least (docs/adr/0028-taut-cloth-keeps-its-shear-stiffness.md).
#pragma once

#include "autodiff_sim/terms/spring.h"

namespace clothfit {

// The springs of nodes 0 and 1 and of nodes 2 and 3. Where there is one, its last node again.
struct BiasSprings {
  std::array<int, 4> nodes;
  int springs;
  std::array<Spring, 2> bias;
};

// Two at a time where they cross in a cell of a grid.
std::vector<BiasSprings> PairBiasSprings(const TermContext& context);

// N/m: each spring's tension over its length, of squared lengths (m^2) and rates (m^2/s) as
// SpringPull has them. stiffness: of each (N/m). Where they are unlike, wrinkles shorten both
// directions alike, and the mean of the two tensions is what is limited.
template <class T>
std::array<T, 2> BiasPulls(const BiasSprings& springs, const std::array<T, 2>& stiffness,
                           const T& damping, const T& bending, const std::array<T, 2>& shrinkage,
                           const std::array<T, 2>& length2, const std::array<T, 2>& rate) {
  using std::sqrt;
  if (springs.springs == 1) {
    return {SpringPull<T>(springs.bias[0], {stiffness[0], damping, bending}, shrinkage, length2[0],
                          rate[0]),
            T(0.0)};
  }
  std::array<T, 2> length, rest_length, tension;
  for (int i = 0; i < 2; ++i) {
    length[i] = sqrt(length2[i]);
    rest_length[i] = RestLength<T>(springs.bias[i], shrinkage);
    tension[i] =
        PlainTension<T>({stiffness[i], damping, bending}, rest_length[i], length[i], rate[i]);
  }
  const T mean_stiffness = 0.5 * (stiffness[0] + stiffness[1]);
  if (Buckles<T>(springs.bias[0], {mean_stiffness, damping, bending})) {
    const T mean = 0.5 * (tension[0] + tension[1]);
    const T load = BucklingLoad<T>(bending, mean_stiffness, springs.bias[0].buckling_length);
    const T wrinkled = (BuckledTension<T>(mean, load) - mean) / mean_stiffness;
    for (int i = 0; i < 2; ++i) tension[i] += stiffness[i] * wrinkled;
  }
  for (int i = 0; i < 2; ++i)
    tension[i] = tension[i] * (rest_length[i] * springs.bias[i].weight) / length[i];
  return tension;
}

struct Shear : TermDefaults {
  static constexpr const char* kName = "shear";
  static constexpr const char* kDoc = "shearing, with damping";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3.1, f_spring";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 4;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  // The longest wave of shear in a metre of cloth (50 N/m, 0.2 kg/m^2) is damped critically by
  // 2 (1 m / pi) sqrt(50 * 0.2) = 2 N s/m; ten times that moves hardly differently from more, with
  // which Newton's method takes several times as long.
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N/m", "shear modulus times thickness", 20.0, 0.0, 0.1, 1e4, Scale::kLog,
            10.0}),
      Free({"damping", "N s/m", "damping of shearing", 3.0, 0.0, 1e-6, 20.0, Scale::kLog, 10.0}),
  }};
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = BiasSprings;
  static std::vector<Element> Elements(const TermContext& context) {
    return PairBiasSprings(context);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Shear, T>& in,
                       ElementOutput<Shear, T>* out) {
    std::array<Vector3<T>, 2> dx;
    std::array<T, 2> length2{T(1.0), T(1.0)}, rate{T(0.0), T(0.0)};
    for (int i = 0; i < element.springs; ++i) {
      dx[i] = in.x[2 * i + 1] - in.x[2 * i];
      length2[i] = dx[i].dot(dx[i]);
      rate[i] = dx[i].dot(in.v[2 * i + 1] - in.v[2 * i]);
    }
    const T& stiffness = in.parameter[0];
    const std::array<T, 2> pulls = BiasPulls<T>(element, {stiffness, stiffness}, in.parameter[1],
                                                in.read[0], in.shrinkage, length2, rate);
    for (int i = 0; i < element.springs; ++i)
      AddPull<T>(pulls[i], dx[i], &out->force[2 * i], &out->force[2 * i + 1]);
  }

  // With the pulls P_i(dx_j.dx_j, dx_j.dv_j) of two springs that cross:
  //   d(P_i dx_i) = P_i d(dx_i) + dx_i sum_j (2 P_ij1 dx_j + P_ij2 dv_j).d(dx_j) + P_ij2
  //   dx_j.d(dv_j).
  template <class Sink>
  static void AddJacobian(const Element& element, const ElementInput<Shear, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    using T = Dual<WholeRegisters(4)>;
    std::array<Eigen::Vector3d, 2> dx, dv;
    std::array<T, 2> length2{T(1.0), T(1.0)}, rate{T(0.0), T(0.0)};
    for (int i = 0; i < element.springs; ++i) {
      dx[i] = in.x[2 * i + 1] - in.x[2 * i];
      dv[i] = in.v[2 * i + 1] - in.v[2 * i];
      length2[i] = T(dx[i].squaredNorm());
      rate[i] = T(dx[i].dot(dv[i]));
      length2[i].SetDerivative(2 * i, 1.0);
      rate[i].SetDerivative(2 * i + 1, 1.0);
    }
    const T stiffness(in.parameter[0]);
    const std::array<T, 2> pulls =
        BiasPulls<T>(element, {stiffness, stiffness}, T(in.parameter[1]), T(in.read[0]),
                     {T(in.shrinkage[0]), T(in.shrinkage[1])}, length2, rate);
    for (int i = 0; i < element.springs; ++i) {
      for (int j = 0; j < element.springs; ++j) {
        const double by_length2 = pulls[i].derivative(2 * j);
        const double by_rate = pulls[i].derivative(2 * j + 1);
        const JacobianRow gradient =
            JacobianRow((2.0 * weights.x * by_length2 + weights.v * by_rate) * dx[j] +
                        weights.x * by_rate * dv[j]);
        for (int p = 0; p < 3; ++p) {
          JacobianRow row = dx[i][p] * gradient;
          if (i == j) row += JacobianRow(weights.x * pulls[i].a * Eigen::Vector3d::Unit(p));
          sink(2 * i, 2 * j + 1, p, row);
          sink(2 * i, 2 * j, p, -row);
          sink(2 * i + 1, 2 * j, p, row);
          sink(2 * i + 1, 2 * j + 1, p, -row);
        }
      }
    }
  }

  static double Energy(const Element& element, const ElementInput<Shear, double>& in);
};

}  // namespace clothfit
