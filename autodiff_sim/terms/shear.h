// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Shearing of the cloth: what it adds to the membrane of the stretch springs, at the mean strain of
// each cell of a grid, or of each triangle of another mesh. Stretch and shear buckle together
// (term/buckling.h), so that the stress of shear alone is
//   S(e_warp, e_weft, shear) - S(e_warp, e_weft, no shear).
// The shear is x_u . x_v, the change of the angle between the threads for small strains (Baraff and
// Witkin 1998, sec. 4.2). On a mesh that does not buckle these are the springs along the bias of
// Hasler et al. 2007.
#pragma once

#include "autodiff_sim/term/shear_strain.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct Shear : TermDefaults {
  static constexpr const char* kName = "shear";
  static constexpr const char* kDoc = "shearing, with damping";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3.1, f_spring";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 4;
  static constexpr bool kUsesShrinkage = true;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      Free({"stiffness", "N/m", "shear modulus times thickness", 20.0, 0.0, 0.1, 1e4, Scale::kLog,
            10.0}),
      Free({"damping", "N s/m", "damping of shearing", 3.0, 0.0, 1e-6, 100.0, Scale::kLog, 10.0}),
  }};
  static constexpr std::array<const char*, 4> kReads = {
      "stretch.stiffness", "stretch.damping", "bending.stiffness", "stretch_orthotropy.ratio"};
  struct Element {
    std::array<int, 4> nodes;      // the last ones again where there are fewer
    double area;                   // m^2
    double length;                 // m, of the wrinkles; 0: springs along the bias
    std::array<double, 4> du, dv;  // 1/m, x_u = sum of du[i] x_i
    // The springs, of nodes 0 and 1 and of nodes 2 and 3; the second one may be missing.
    int springs;
    std::array<Spring, 2> bias;
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Shear, T>& in,
                       ElementOutput<Shear, T>* out) {
    if (element.length == 0.0) {
      const SpringLaw<T> law = {in.parameter[0], in.parameter[1], T(0.0)};
      for (int i = 0; i < element.springs; ++i) {
        AddSpringForce<T>(element.bias[i], law, in.shrinkage, 2 * i, 2 * i + 1, in.x, in.v,
                          &out->force);
      }
      return;
    }
    using std::sqrt;
    std::array<Vector3<T>, 2> x, rate;  // along warp and weft
    std::array<T, 2> length;
    for (int d = 0; d < 2; ++d) {
      const std::array<double, 4>& weights = d == 0 ? element.du : element.dv;
      const T scale = 1.0 / (1.0 - in.shrinkage[d]);
      x[d] = AlongCloth<T>(weights, in.x) * scale;
      rate[d] = AlongCloth<T>(weights, in.v) * scale;
      length[d] = sqrt(x[d].dot(x[d]));
    }
    const PlaneStress<T> strain = {length[0] - 1.0, length[1] - 1.0, x[0].dot(x[1])};
    const PlaneStress<T> strain_rate = {x[0].dot(rate[0]) / length[0],
                                        x[1].dot(rate[1]) / length[1],
                                        x[0].dot(rate[1]) + x[1].dot(rate[0])};
    const PlaneStress<T> stress = Stress<T>(element, in, strain, strain_rate);
    for (int d = 0; d < 2; ++d) {
      const std::array<double, 4>& weights = d == 0 ? element.du : element.dv;
      const T scale = element.area / (1.0 - in.shrinkage[d]);
      const T pull = stress[d] * scale / length[d], turn = stress[2] * scale;
      for (int k = 0; k < 3; ++k) {
        const T f = pull * x[d][k] + turn * x[1 - d][k];
        for (int i = 0; i < 4; ++i)
          if (weights[i] != 0.0) out->force[i][k] -= f * weights[i];
      }
    }
  }

  static bool WritesJacobian(const Element& element) { return element.length == 0.0; }
  template <class Sink>
  static void AddJacobian(const Element& element, const ElementInput<Shear, double>& in,
                          const JacobianWeights& weights, const Sink& sink) {
    for (int i = 0; i < element.springs; ++i) {
      AddSpringJacobian(element.bias[i], {in.parameter[0], in.parameter[1], 0.0}, in.shrinkage,
                        2 * i, 2 * i + 1, in.x, in.v, weights, sink);
    }
  }

  static double Energy(const Element& element, const ElementInput<Shear, double>& in);

 private:
  // N/m, along warp and weft, see terms/orthotropy.h.
  template <class T>
  static std::array<T, 2> Stretch(const ElementInput<Shear, T>& in) {
    using std::sqrt;
    if (Value(in.read[3]) <= 0.0) return {in.read[0], in.read[0]};
    const T root = sqrt(in.read[3]);
    return {in.read[0] * root, in.read[0] / root};
  }

  template <class T>
  static PlaneStress<T> Stress(const Element& element, const ElementInput<Shear, T>& in,
                               const PlaneStress<T>& strain, const PlaneStress<T>& rate) {
    const std::array<T, 2> stretch = Stretch<T>(in);
    const T viscous_shear = in.parameter[1] * rate[2];
    if (Value(in.read[0]) <= 0.0)
      return {T(0.0), T(0.0), in.parameter[0] * strain[2] + viscous_shear};
    const T load = BucklingLoad<T>(in.read[2], in.read[0], element.length);
    const PlaneStress<T> viscous = {in.read[1] * rate[0], in.read[1] * rate[1], viscous_shear};
    PlaneStress<T> stress =
        BuckledStress<T>({stretch[0], stretch[1], in.parameter[0]}, load, strain, viscous);
    for (int d = 0; d < 2; ++d)
      stress[d] -= BuckledTension<T>(stretch[d], load, strain[d], viscous[d]);
    return stress;
  }
};

}  // namespace clothfit
