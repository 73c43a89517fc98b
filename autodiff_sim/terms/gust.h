// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A gust: wind at one place of the cloth and for a time, on top of the even wind. It swells and
// fades as the one-minus-cosine gust of aircraft design does (EASA CS-25.341(a)),
//   w = peak (1 - cos(2 pi (t - onset) / duration)) / 2,
// within its duration, and falls off around its place as a Gauss curve. It acts as wind does, see
// wind.h: the term is the difference that it makes to the air drag in the even wind.
#pragma once

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/terms/air_drag.h"

namespace clothfit {

struct Gust : TermDefaults {
  static constexpr const char* kName = "gust";
  static constexpr const char* kDoc = "wind at a place of the cloth for a time";
  static constexpr const char* kReference = "one-minus-cosine gust, EASA CS-25.341(a)";
  static constexpr Work kWork = Work::kDrives;
  static constexpr std::array kTies = {Tie::kClock};
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 8> kParameters = {{
      {"x", "m/s", "largest velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorX},
      {"y", "m/s", "largest velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorY},
      {"z", "m/s", "largest velocity of the air", 0.0, 0.0, -10.0, 10.0, Scale::kLinear, 0.3,
       Meaning::kVectorZ},
      Shape({"onset", "s", "when it begins", 0.0, 0.0, -1e3, 1e4, Scale::kLinear, 0.5},
            Meaning::kTime, 0.0, 0.25, 0.5, 0.75),
      Shape({"duration", "s", "how long it lasts", 1.0, 1.0, 0.05, 1e3, Scale::kLog, 2.0},
            Meaning::kTime, 0.25, 0.5),
      kPatchU,
      kPatchV,
      Shape({"radius", "m", "distance at which it has fallen to 61 %", 0.2, 0.2, 0.01, 100.0,
             Scale::kLog, 2.0},
            Meaning::kClothDistance, 0.3, 100.0),
  }};
  static constexpr std::array<const char*, 6> kReads = {
      "air_drag.normal", "air_drag.saturation", "air_drag.tangential", "wind.x", "wind.y",
      "wind.z"};

  struct Element {
    std::array<int, 3> nodes;
    Eigen::Vector2d uv;  // m, the triangle's middle
  };
  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    for (const std::array<int, 3>& nodes : context.mesh.triangles)
      elements.push_back({nodes, MiddleOf(nodes, context.mesh)});
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Gust, T>& in,
                       ElementOutput<Gust, T>* out) {
    using std::sin;
    const std::array<T, 8>& p = in.parameter;
    const T phase = (in.time - p[3]) / p[4];
    if (Value(phase) <= 0.0 || Value(phase) >= 1.0) return;
    const T half = sin(phase * M_PI);  // (1 - cos 2 a) / 2 = sin^2 a
    const T strength = half * half * PatchWeight<T>(element.uv, p[5], p[6], p[7]);
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(1.0 / 3.0);
    const Vector3<T> relative = velocity - Vector3<T>(in.read[3], in.read[4], in.read[5]);
    const Vector3<T> gust(strength * p[0], strength * p[1], strength * p[2]);
    const std::array<T, 3> drag = {in.read[0], in.read[1], in.read[2]};
    const Vector3<T> force =
        AirDragForce<T>(in.x, relative - gust, drag) - AirDragForce<T>(in.x, relative, drag);
    for (Vector3<T>& corner : out->force) corner += force;
  }
};

}  // namespace clothfit
