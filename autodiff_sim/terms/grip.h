// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds the cloth is not always as rigid as a recording takes it for.
//
// A grip that yields: the cloth's point hangs by a spring from the place that holds it,
//   f = -(x - p) / compliance.
// At compliance 0 the point is where the place is, by substitution (handle_constraints.h), and this
// term adds nothing; the derivative of switching it on, dx = -f d compliance with f the force that
// holds the point, is the simulation's (grips.h).
//
// A grip that slips: from `onset` on, the cloth's point moves by a vector against the place,
//   s = (x, y, z) (1 - cos(pi (t - onset) / duration)) / 2
// and stays there, at the places near (u, v) of the cloth. Where the grip yields, that is a force,
// and the term is the difference that it makes; where it is rigid, it moves the place.
#pragma once

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/terms/attraction.h"

namespace clothfit {

// m/N; a grip that yields less is rigid. It moves by less than the solver's tolerance.
constexpr double kRigidCompliance = 1e-9;

struct HeldElement {
  std::array<int, 3> nodes;
  std::array<double, 3> weights;
  Eigen::Vector2d uv;           // m, the held point
  std::array<double, 3> input;  // m, world, the place that holds it
  int first_input;
};

inline std::vector<HeldElement> HeldElements(const TermContext& context) {
  std::vector<HeldElement> elements;
  if (context.inputs == nullptr) return elements;
  int row = 0;
  for (const HandleTarget& handle : context.inputs->handles) {
    const SurfacePoint& point = handle.on_cloth;
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < 3; ++i) uv += point.weights[i] * context.mesh.uv[point.nodes[i]];
    const Eigen::Vector3d& p = handle.position;
    elements.push_back({point.nodes, point.weights, uv, {p.x(), p.y(), p.z()}, row});
    row += 3;
  }
  return elements;
}

struct Grip : TermDefaults {
  static constexpr const char* kName = "grip";
  static constexpr const char* kTitle = "yielding grips";
  static constexpr const char* kDoc = "grips that yield to the cloth's pull";
  static constexpr const char* kReference = "linear spring";
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr int kInputs = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 1> kParameters = {{
      {"compliance", "m/N", "way per force that holds the cloth", 0.0, 0.0, 0.0, 1.0,
       Scale::kLinear, 2e-3},
  }};
  using Element = HeldElement;
  static std::vector<Element> Elements(const TermContext& context) { return HeldElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Grip, T>& in,
                       ElementOutput<Grip, T>* out) {
    const T& compliance = in.parameter[0];
    if (Value(compliance) < kRigidCompliance) return;
    const Vector3<T> place(in.input[0], in.input[1], in.input[2]);
    const Vector3<T> pull =
        (place - SurfacePosition<T>(element.weights, in.x)) * (1.0 / compliance);
    for (int i = 0; i < 3; ++i) out->force[i] += pull * T(element.weights[i]);
  }
};

struct GripSlip : TermDefaults {
  static constexpr const char* kName = "grip_slip";
  static constexpr const char* kTitle = "slip in a grip";
  static constexpr const char* kDoc = "a grip in which the cloth slips";
  static constexpr const char* kReference = "displacement that sets in as a cosine";
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kClock};
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr int kInputs = 3;
  static constexpr std::array<Parameter, 8> kParameters = {{
      {"x", "m", "how far the cloth moves in it", 0.0, 0.0, -0.5, 0.5, Scale::kLinear, 0.01,
       Meaning::kVectorX},
      {"y", "m", "how far the cloth moves in it", 0.0, 0.0, -0.5, 0.5, Scale::kLinear, 0.01,
       Meaning::kVectorY},
      {"z", "m", "how far the cloth moves in it", 0.0, 0.0, -0.5, 0.5, Scale::kLinear, 0.01,
       Meaning::kVectorZ},
      Shape({"onset", "s", "when it begins", 0.0, 0.0, -1e3, 1e4, Scale::kLinear, 0.5},
            Meaning::kTime, 0.1, 0.4),
      Shape({"duration", "s", "how long it moves", 0.5, 0.5, 0.02, 1e3, Scale::kLog, 2.0},
            Meaning::kTime, 0.1),
      Shape({"u", "m", "of the cloth that slips, along the warp", 0.0, 0.0, -10.0, 10.0,
             Scale::kLinear, 0.1},
            Meaning::kClothU, 0.0, 1.0),
      Shape({"v", "m", "of the cloth that slips, along the weft", 0.0, 0.0, -10.0, 10.0,
             Scale::kLinear, 0.1},
            Meaning::kClothV, 0.0, 1.0),
      Shape({"radius", "m", "distance at which it has fallen to 61 %", 0.1, 0.1, 0.01, 100.0,
             Scale::kLog, 2.0},
            Meaning::kClothDistance, 0.25),
  }};
  static constexpr std::array<const char*, 1> kReads = {"grip.compliance"};
  using Element = HeldElement;
  static std::vector<Element> Elements(const TermContext& context) { return HeldElements(context); }

  // m, world: how far the cloth's point at `uv` has moved in its grip. p: as kParameters.
  template <class T>
  static Vector3<T> Displacement(const Eigen::Vector2d& uv, double time,
                                 const std::array<T, 8>& p) {
    using std::sin;
    const T phase = (time - p[3]) / p[4];
    T share(0.0);
    if (Value(phase) >= 1.0) {
      share = T(1.0);
    } else if (Value(phase) > 0.0) {
      const T half = sin(phase * (0.5 * M_PI));  // (1 - cos 2 a) / 2 = sin^2 a
      share = half * half;
    }
    share *= PatchWeight<T>(uv, p[5], p[6], p[7]);
    return Vector3<T>(share * p[0], share * p[1], share * p[2]);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<GripSlip, T>& in,
                       ElementOutput<GripSlip, T>* out) {
    const T& compliance = in.read[0];
    if (Value(compliance) < kRigidCompliance) return;
    const Vector3<T> pull = Displacement<T>(element.uv, in.time, in.parameter) * (1.0 / compliance);
    for (int i = 0; i < 3; ++i) out->force[i] += pull * T(element.weights[i]);
  }
};

}  // namespace clothfit
