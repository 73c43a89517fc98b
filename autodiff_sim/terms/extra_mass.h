// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Mass that the cloth's areal density leaves out: a hem along a side, or a patch that is heavier
// (wet, printed, sewn on). Each particle's share m weighs and resists acceleration,
//   f = m (s R g - a),
// s R g gravity as the terms gravity and gravity_tilt have it, a the acceleration of the
// integrator's own formula: the step is that of a cloth of which m is a part.
#pragma once

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/term/term.h"
#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {

// What the parameters of gravity and its tilt make of a mass (kg).
template <class T>
Vector3<T> ForceOfMass(const T& mass, const DownFrame& frame, double gravity,
                       const std::array<T, 3>& scale_and_tilt, const Vector3<T>& acceleration) {
  const Vector3<T> down = TiltedDown<T>(frame, scale_and_tilt[1], scale_and_tilt[2]);
  const T size = scale_and_tilt[0] * gravity;
  Vector3<T> force;
  for (int k = 0; k < 3; ++k) force[k] = mass * (size * down[k] - acceleration[k]);
  return force;
}

constexpr std::array<const char*, 3> kGravityParameters = {"gravity.scale", "gravity_tilt.angle_1",
                                                           "gravity_tilt.angle_2"};

struct Hem : TermDefaults {
  static constexpr const char* kName = "hem";
  static constexpr const char* kDoc = "mass along the sides of the cloth";
  static constexpr const char* kReference = "Newton";
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kUsesAcceleration = true;
  static constexpr std::array<Parameter, 4> kParameters = {{
      {"low_u", "kg/m", "along the side of least u", 0.0, 0.0, 0.0, 1.0, Scale::kLinear, 0.02},
      {"high_u", "kg/m", "along the side of largest u", 0.0, 0.0, 0.0, 1.0, Scale::kLinear, 0.02},
      {"low_v", "kg/m", "along the side of least v", 0.0, 0.0, 0.0, 1.0, Scale::kLinear, 0.02},
      {"high_v", "kg/m", "along the side of largest v", 0.0, 0.0, 0.0, 1.0, Scale::kLinear, 0.02},
  }};
  static constexpr std::array<const char*, 3> kReads = kGravityParameters;

  struct Element {
    std::array<int, 1> nodes;
    std::array<double, 4> length;  // m, of each side that the particle stands for
    double gravity;                // m/s^2
    DownFrame frame;
  };
  // On a cloth that is no rectangle a piece of the border counts to the sides that it faces, by the
  // squared cosines of its normal's angles to u and v.
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Hem, T>& in,
                       ElementOutput<Hem, T>* out) {
    T mass = T(0.0);
    for (int side = 0; side < 4; ++side) mass += in.parameter[side] * element.length[side];
    out->force[0] += ForceOfMass<T>(mass, element.frame, element.gravity, in.read, in.a[0]);
  }
};

struct HeavyPatch : TermDefaults {
  static constexpr const char* kName = "heavy_patch";
  static constexpr const char* kDoc = "a place of the cloth that is heavier, or lighter";
  static constexpr const char* kReference = "Newton";
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kUsesAcceleration = true;
  static constexpr bool kUsesDensity = true;
  static constexpr std::array<Parameter, 4> kParameters = {{
      {"share", "1", "mass at its middle beside the cloth's own, over that", 0.0, 0.0, -0.9, 10.0,
       Scale::kLinear, 0.5},
      kPatchU,
      kPatchV,
      kPatchRadius,
  }};
  static constexpr std::array<const char*, 3> kReads = kGravityParameters;

  struct Element {
    std::array<int, 1> nodes;
    double area;         // m^2
    Eigen::Vector2d uv;  // m
    double gravity;      // m/s^2
    DownFrame frame;
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<HeavyPatch, T>& in,
                       ElementOutput<HeavyPatch, T>* out) {
    const std::array<T, 4>& p = in.parameter;
    const T weight = PatchWeight<T>(element.uv, p[1], p[2], p[3]);
    const T mass = p[0] * weight * in.areal_density * element.area;
    out->force[0] += ForceOfMass<T>(mass, element.frame, element.gravity, in.read, in.a[0]);
  }
};

}  // namespace clothfit
