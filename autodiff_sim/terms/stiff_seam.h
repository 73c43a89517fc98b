// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A straight seam that stretches and bends less than the rest of the cloth, each by its own term:
// what it adds to the springs of spring.h and the folds of bending.h, without their damping.
#pragma once

#include <cmath>

#include "autodiff_sim/term/fold_angle.h"
#include "autodiff_sim/term/stiff_region.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct StiffSeamStretch : TermDefaults {
  static constexpr const char* kName = "stiff_seam_stretch";
  static constexpr const char* kTitle = "seam that stretches less";
  static constexpr const char* kDoc = "a straight seam that stretches less";
  static constexpr const char* kReference = "as the stretch springs";
  static constexpr int kNodes = 2;
  static constexpr bool kInternal = true;
  static constexpr bool kUsesShrinkage = true;
  static constexpr std::array<Parameter, 4> kParameters = kStiffSeamParameters;
  static constexpr std::array<const char*, 2> kReads = {"stretch.stiffness", "bending.stiffness"};
  using Element = Placed<Spring>;
  static std::vector<Element> Elements(const TermContext& context) {
    return Place(context.topology.structural, context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StiffSeamStretch, T>& in,
                       ElementOutput<StiffSeamStretch, T>* out) {
    AddExtraSpringForce<T>(element.elastic, in.read[0],
                           StiffSeamFactor<T>(element.from_middle, in.parameter), in.read[1],
                           in.shrinkage, in.x, &out->force);
  }
};

struct StiffSeamBending : TermDefaults {
  static constexpr const char* kName = "stiff_seam_bending";
  static constexpr const char* kTitle = "seam that bends less";
  static constexpr const char* kDoc = "a straight seam that bends less";
  static constexpr const char* kReference = "as the bending folds";
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 4> kParameters = kStiffSeamParameters;
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = Placed<Hinge>;
  static std::vector<Element> Elements(const TermContext& context) {
    return Place(context.topology.hinges, context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StiffSeamBending, T>& in,
                       ElementOutput<StiffSeamBending, T>* out) {
    const T stiffness = in.read[0] * StiffSeamFactor<T>(element.from_middle, in.parameter);
    const Fold<T> fold = MakeFold<T>(in.x);
    const T moment = stiffness * element.elastic.shape * HalveAngle<T>(fold).sine;
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
