// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ground that holds the cloth, everywhere or at a patch of it, with a traction that rises with the
// gap g, is largest at the range r and fades beyond,
//   traction = pressure (g / r)^2 exp(2 (1 - g / r)),
// an exponential law of decohesion as that of Xu and Needleman 1994, squared so that its slope too
// is continuous where the gap closes. The ground's own contact pushes back; see ground_contact.h.
// It does not hold along the ground: that is friction's.
#pragma once

#include <cmath>

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// Share of the largest traction at a gap.
template <class T>
T AdhesionShare(const T& gap, const T& range) {
  using std::exp;
  if (Value(gap) <= 0.0) return T(0.0);
  const T ratio = gap / range;
  return ratio * ratio * exp(2.0 * (1.0 - ratio));
}

constexpr Parameter kAdhesionPressure = {"pressure", "Pa", "largest traction", 0.0, 0.0,
                                         0.0,        1e4,  Scale::kLinear,     1.0};
constexpr Parameter kAdhesionRange =
    Shape({"range", "m", "gap at which it is largest", 0.003, 0.003, 1e-4, 0.1, Scale::kLog, 2.0},
          Meaning::kNumber, 0.003, 0.01);

struct GroundElement {
  std::array<int, 1> nodes;
  double area;         // m^2
  double height;       // m, of the ground
  Eigen::Vector2d uv;  // m
};
std::vector<GroundElement> GroundElements(const TermContext& context);

struct Adhesion : TermDefaults {
  static constexpr const char* kName = "adhesion";
  static constexpr const char* kTitle = "sticky ground";
  static constexpr const char* kDoc = "ground that holds the cloth down";
  static constexpr const char* kReference = "after Xu and Needleman 1994";
  static constexpr std::array kTies = {Tie::kContact};
  static constexpr Needs kNeeds = Needs::kGround;
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 2> kParameters = {{kAdhesionPressure, kAdhesionRange}};
  using Element = GroundElement;
  static std::vector<Element> Elements(const TermContext& context) {
    return GroundElements(context);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Adhesion, T>& in,
                       ElementOutput<Adhesion, T>* out) {
    const T gap = in.x[0].z() - element.height;
    out->force[0].z() -= in.parameter[0] * element.area * AdhesionShare<T>(gap, in.parameter[1]);
  }
};

struct StickyPatch : TermDefaults {
  static constexpr const char* kName = "sticky_patch";
  static constexpr const char* kDoc = "ground that holds a patch of the cloth down";
  static constexpr const char* kReference = "after Xu and Needleman 1994";
  static constexpr std::array kTies = {Tie::kContact};
  static constexpr Needs kNeeds = Needs::kGround;
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 5> kParameters = {{
      kAdhesionPressure,
      kAdhesionRange,
      kPatchU,
      kPatchV,
      kPatchRadius,
  }};
  using Element = GroundElement;
  static std::vector<Element> Elements(const TermContext& context) {
    return GroundElements(context);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<StickyPatch, T>& in,
                       ElementOutput<StickyPatch, T>* out) {
    const std::array<T, 5>& p = in.parameter;
    const T gap = in.x[0].z() - element.height;
    const T weight = PatchWeight<T>(element.uv, p[2], p[3], p[4]);
    out->force[0].z() -= p[0] * element.area * weight * AdhesionShare<T>(gap, p[1]);
  }
};

}  // namespace clothfit
