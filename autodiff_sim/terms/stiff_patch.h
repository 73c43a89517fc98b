// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A patch, such as a print that stretches and bends less than the rest of the cloth, each by its
// own term: what it adds to the springs of spring.h and the folds of bending.h, without their
// damping.
#pragma once

#include <cmath>

#include "autodiff_sim/term/fold_angle.h"
#include "autodiff_sim/term/stiff_region.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

struct StiffPatchStretch : TermDefaults {
  static constexpr const char* kName = "stiff_patch_stretch";
  static constexpr const char* kTitle = "patch that stretches less";
  static constexpr const char* kDoc = "a patch, such as a print, that stretches less";
  static constexpr const char* kReference = "as the stretch springs";
  static constexpr int kNodes = 2;
  static constexpr bool kInternal = true;
  static constexpr bool kUsesShrinkage = true;
  static constexpr std::array<Parameter, 4> kParameters = kStiffPatchParameters;
  static constexpr std::array<const char*, 2> kReads = {"stretch.stiffness", "bending.stiffness"};
  using Element = Placed<Spring>;
  static std::vector<Element> Elements(const TermContext& context) {
    return Place(context.topology.structural, context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StiffPatchStretch, T>& in,
                       ElementOutput<StiffPatchStretch, T>* out) {
    AddExtraSpringForce<T>(element.elastic, in.read[0],
                           StiffPatchFactor<T>(element.uv, in.parameter), in.read[1], in.shrinkage,
                           in.x, &out->force);
  }
};

struct StiffPatchBending : TermDefaults {
  static constexpr const char* kName = "stiff_patch_bending";
  static constexpr const char* kTitle = "patch that bends less";
  static constexpr const char* kDoc = "a patch, such as a print, that bends less";
  static constexpr const char* kReference = "as the bending folds";
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 4> kParameters = kStiffPatchParameters;
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = Placed<Hinge>;
  static std::vector<Element> Elements(const TermContext& context) {
    return Place(context.topology.hinges, context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StiffPatchBending, T>& in,
                       ElementOutput<StiffPatchBending, T>* out) {
    const T stiffness = in.read[0] * StiffPatchFactor<T>(element.uv, in.parameter);
    const Fold<T> fold = MakeFold<T>(in.x);
    const T moment = stiffness * element.elastic.shape * HalveAngle<T>(fold).sine;
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
