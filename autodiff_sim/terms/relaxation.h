// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Relaxation: the standard linear solid. Beside the spring of modulus k, which lasts, stands one of
// share * k in a row with a dashpot, whose strain q relaxes,
//   f = k e + share k q,  dq/dt = de/dt - q / time.
// Over a step h through which the strain moves evenly from e to e' that is, exactly (Simo and
// Hughes 1998, Computational Inelasticity, ch. 10, with the step's strain rate in place of the
// mid-point rule),
//   q' = exp(-h / time) q + (1 - exp(-h / time)) / (h / time) (e' - e).
// q is zero at first: a cloth that has lain in its first shape for long.
#pragma once

#include <cmath>

#include "autodiff_sim/term/fold_angle.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// q at the end of a step from q before; ratio: the step over the relaxation time.
template <class T>
T RelaxStrain(const T& before, const T& strain_change, const T& ratio) {
  using std::exp;
  const T left = exp(-ratio);
  // (1 - exp(-r)) / r, by its series where the difference would cancel.
  constexpr double kSmall = 1e-2;
  const T mean =
      Value(ratio) > kSmall
          ? T((1.0 - left) / ratio)
          : T(1.0 - ratio * (1.0 / 2.0) *
                        (1.0 - ratio * (1.0 / 3.0) *
                                   (1.0 - ratio * (1.0 / 4.0) * (1.0 - ratio * (1.0 / 5.0)))));
  return before * left + mean * strain_change;
}

// The memory is the extension (m) that has not relaxed yet.
template <class T>
void AddRelaxingSpring(const Spring& spring, const T& stiffness, const T& ratio,
                       const std::array<Vector3<T>, 2>& x, const std::array<Vector3<T>, 2>& start,
                       T* memory, std::array<Vector3<T>, 2>* force) {
  using std::sqrt;
  const Vector3<T> dx = x[1] - x[0], dx_start = start[1] - start[0];
  const T length = sqrt(dx.dot(dx));
  *memory = RelaxStrain<T>(*memory, length - sqrt(dx_start.dot(dx_start)), ratio);
  const T pull = stiffness * spring.weight * *memory / length;
  for (int k = 0; k < 3; ++k) {
    (*force)[0][k] += pull * dx[k];
    (*force)[1][k] -= pull * dx[k];
  }
}

constexpr Parameter kRelaxingShare = {
    "share",        "1", "stiffness that relaxes, over the one that lasts", 0.0, 0.0, 0.0, 10.0,
    Scale::kLinear, 0.2};
constexpr Parameter kRelaxationTime =
    Shape({"time", "s", "relaxation time", 1.0, 1.0, 1e-3, 1e4, Scale::kLog, 5.0}, Meaning::kNumber,
          0.1, 1.0, 10.0, 100.0);

struct StretchRelaxation : TermDefaults {
  static constexpr const char* kName = "stretch_relaxation";
  static constexpr const char* kDoc = "stretching that relaxes along warp and weft";
  static constexpr const char* kReference = "standard linear solid; Simo and Hughes 1998, ch. 10";
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 2;
  static constexpr int kMemory = 1;  // q, m
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{kRelaxingShare, kRelaxationTime}};
  static constexpr std::array<const char*, 1> kReads = {"stretch.stiffness"};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.structural;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StretchRelaxation, T>& in,
                       ElementOutput<StretchRelaxation, T>* out) {
    AddRelaxingSpring<T>(element, in.parameter[0] * in.read[0], in.step / in.parameter[1], in.x,
                         in.start, &out->memory[0], &out->force);
  }
};

struct ShearRelaxation : TermDefaults {
  static constexpr const char* kName = "shear_relaxation";
  static constexpr const char* kDoc = "shearing that relaxes";
  static constexpr const char* kReference = "standard linear solid; Simo and Hughes 1998, ch. 10";
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 2;
  static constexpr int kMemory = 1;  // q, m
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{kRelaxingShare, kRelaxationTime}};
  static constexpr std::array<const char*, 1> kReads = {"shear.stiffness"};
  using Element = Spring;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.shear;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ShearRelaxation, T>& in,
                       ElementOutput<ShearRelaxation, T>* out) {
    AddRelaxingSpring<T>(element, in.parameter[0] * in.read[0], in.step / in.parameter[1], in.x,
                         in.start, &out->memory[0], &out->force);
  }
};

struct BendingRelaxation : TermDefaults {
  static constexpr const char* kName = "bending_relaxation";
  static constexpr const char* kDoc = "bending that relaxes";
  static constexpr const char* kReference = "standard linear solid; Simo and Hughes 1998, ch. 10";
  static constexpr Work kWork = Work::kDissipates;
  static constexpr int kNodes = 4;
  static constexpr int kMemory = 1;  // q, no unit
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{kRelaxingShare, kRelaxationTime}};
  static constexpr std::array<const char*, 1> kReads = {"bending.stiffness"};
  using Element = Hinge;

  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.hinges;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<BendingRelaxation, T>& in,
                       ElementOutput<BendingRelaxation, T>* out) {
    // What bending.h resists is sin(theta / 2).
    const Fold<T> fold = MakeFold<T>(in.x);
    const T before = HalveAngle<T>(MakeFold<T>(in.start)).sine;
    out->memory[0] = RelaxStrain<T>(out->memory[0], HalveAngle<T>(fold).sine - before,
                                    in.step / in.parameter[1]);
    const T moment = in.parameter[0] * in.read[0] * element.shape * out->memory[0];
    AddFlatteningMoment<T>(moment, FlatteningMode<T>(fold), &out->force);
  }
};

}  // namespace clothfit
