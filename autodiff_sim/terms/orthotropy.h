// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Threads of two kinds: stiffness along the warp that is not the one along the weft. Each stiffness
// k is split by the ratio r of warp to weft so that its geometric mean stays,
//   k_warp = k sqrt(r),  k_weft = k / sqrt(r),
// and in between k r^(c^2 - 1/2), c the cosine of the direction's angle to the warp; shear's is the
// ratio of one bias to the other. The terms are what that adds to the springs and folds of
// spring.h and bending.h, without their damping.
#pragma once

#include <cmath>

#include "autodiff_sim/term/fold_angle.h"
#include "autodiff_sim/terms/shear.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

template <class Elastic>
struct Directed {
  std::array<int, std::tuple_size_v<decltype(Elastic::nodes)>> nodes;
  Elastic elastic;
  double exponent;  // of the ratio, -1/2 to 1/2
};

// What the ratio adds to a stiffness, as a share of it.
template <class T>
T ExtraShare(const T& ratio, double exponent) {
  using std::pow;
  return pow(ratio, exponent) - 1.0;
}

constexpr Parameter kWarpOverWeft = {
    "ratio",     "1", "stiffness along the warp over that along the weft", 1.0, 1.0, 0.02, 50.0,
    Scale::kLog, 2.0};

struct StretchOrthotropy : TermDefaults {
  static constexpr const char* kName = "stretch_orthotropy";
  static constexpr const char* kTitle = "unequal stretching along warp and weft";
  static constexpr const char* kDoc = "stretching unlike along warp and weft";
  static constexpr const char* kReference = "orthotropic plate, Lekhnitskii 1968";
  static constexpr int kNodes = 2;
  static constexpr bool kInternal = true;
  static constexpr bool kUsesShrinkage = true;
  static constexpr std::array<Parameter, 1> kParameters = {{kWarpOverWeft}};
  static constexpr std::array<const char*, 2> kReads = {"stretch.stiffness", "bending.stiffness"};
  using Element = Directed<Spring>;
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StretchOrthotropy, T>& in,
                       ElementOutput<StretchOrthotropy, T>* out) {
    AddExtraSpringForce<T>(element.elastic, in.read[0],
                           ExtraShare<T>(in.parameter[0], element.exponent), in.read[1],
                           in.shrinkage, in.x, &out->force);
  }
};

struct ShearOrthotropy : TermDefaults {
  static constexpr const char* kName = "shear_orthotropy";
  static constexpr const char* kTitle = "unequal shearing along the two diagonals";
  static constexpr const char* kDoc = "shearing unlike along the two bias directions";
  static constexpr const char* kReference = "orthotropic plate, Lekhnitskii 1968";
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr bool kUsesShrinkage = true;
  static constexpr std::array<Parameter, 1> kParameters = {
      {{"ratio", "1", "stiffness along the bias u = v over that along u = -v", 1.0, 1.0, 0.02, 50.0,
        Scale::kLog, 2.0}}};
  static constexpr std::array<const char*, 2> kReads = {"shear.stiffness", "bending.stiffness"};
  struct Element {
    std::array<int, 4> nodes;
    BiasSprings elastic;
    std::array<double, 2> exponent;
  };
  static std::vector<Element> Elements(const TermContext& context);

  // What the springs pull with their own stiffnesses, less what they pull with the same.
  template <class T>
  static void AddForce(const Element& element, const ElementInput<ShearOrthotropy, T>& in,
                       ElementOutput<ShearOrthotropy, T>* out) {
    const BiasSprings& springs = element.elastic;
    std::array<Vector3<T>, 2> dx;
    std::array<T, 2> length2{T(1.0), T(1.0)}, own;
    for (int i = 0; i < springs.springs; ++i) {
      dx[i] = in.x[2 * i + 1] - in.x[2 * i];
      length2[i] = dx[i].dot(dx[i]);
    }
    for (int i = 0; i < 2; ++i)
      own[i] = in.read[0] * (1.0 + ExtraShare<T>(in.parameter[0], element.exponent[i]));
    const auto pulls = [&](const std::array<T, 2>& stiffness) {
      return BiasPulls<T>(springs, stiffness, T(0.0), in.read[1], in.shrinkage, length2,
                          {T(0.0), T(0.0)});
    };
    const std::array<T, 2> unlike = pulls(own), alike = pulls({in.read[0], in.read[0]});
    for (int i = 0; i < springs.springs; ++i)
      AddPull<T>(unlike[i] - alike[i], dx[i], &out->force[2 * i], &out->force[2 * i + 1]);
  }
};

struct BendingOrthotropy : TermDefaults {
  static constexpr const char* kName = "bending_orthotropy";
  static constexpr const char* kTitle = "unequal bending along warp and weft";
  static constexpr const char* kDoc = "bending unlike along warp and weft";
  static constexpr const char* kReference = "orthotropic plate, Lekhnitskii 1968";
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 1> kParameters = {{kWarpOverWeft}};
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = Directed<Hinge>;
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<BendingOrthotropy, T>& in,
                       ElementOutput<BendingOrthotropy, T>* out) {
    const T stiffness = in.read[0] * ExtraShare<T>(in.parameter[0], element.exponent);
    const Fold<T> fold = MakeFold<T>(in.x);
    const T moment = stiffness * element.elastic.shape * HalveAngle<T>(fold).sine;
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
