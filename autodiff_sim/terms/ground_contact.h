// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Contact of a particle with the ground plane z = height. Within the contact distance d the ground
// pushes with f_n = A k (d - g)^2 / d, g the gap, whose slope is continuous; friction is Coulomb's,
// regularised so that it has a derivative where the cloth sticks and where it slides:
//   f_t = -mu f_n v_t / sqrt(|v_t|^2 + s^2).
// Below the slip speed s a sticking point creeps; it is the model's error at rest.
#pragma once

#include <algorithm>
#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct GroundContact : TermDefaults {
  static constexpr const char* kName = "ground";
  static constexpr const char* kDoc = "contact with the ground plane, with Coulomb friction";
  static constexpr const char* kReference = "Coulomb friction, regularised";
  static constexpr Role kRole = Role::kOrdinary;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kContact};
  static constexpr Needs kNeeds = Needs::kGround;
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 5> kParameters = {{
      {"stiffness", "Pa/m", "pressure of the ground per depth", 1e5, 0.0, 1e3, 1e8, Scale::kLog,
       10.0},
      Free({"friction", "1", "Coulomb's coefficient mu", 0.4, 0.0, 0.0, 2.0, Scale::kLinear, 0.3}),
      {"damping", "Pa s/m^2", "damping of the push, per depth", 0.0, 0.0, 0.0, 1e6, Scale::kLinear,
       1e3},
      {"distance", "m", "gap at which contact begins", 0.002, 0.002, 1e-4, 0.02, Scale::kLog, 2.0},
      {"slip_speed", "m/s", "speed below which friction sticks", 0.005, 0.005, 1e-5, 0.1,
       Scale::kLog, 3.0},
  }};

  struct Element {
    std::array<int, 1> nodes;
    double area;    // m^2
    double height;  // m
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    if (!context.world.ground_height) return elements;
    for (int i = 0; i < context.mesh.num_particles(); ++i) {
      elements.push_back({{i}, context.topology.areas[i], *context.world.ground_height});
    }
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<GroundContact, T>& in,
                       ElementOutput<GroundContact, T>* out) {
    using std::sqrt;
    const T& distance = in.parameter[3];
    const T depth = distance - (in.x[0].z() - element.height);
    if (Value(depth) <= 0.0) return;
    // The damping grows with the depth, so that it too sets in without a jump.
    const T elastic = element.area * in.parameter[0] * depth * depth / distance;
    const T viscous = -element.area * in.parameter[2] * depth * in.v[0].z();
    // The ground does not hold the cloth down. Without stiffness the derivatives are those of
    // switching it on, and damping by itself only brakes what sinks in.
    const bool pushes = Value(elastic) + Value(viscous) >= 0.0;
    const bool brakes = Value(elastic) > 0.0 || Value(in.v[0].z()) < 0.0;
    const T normal_force = !pushes ? T(0.0) : brakes ? elastic + viscous : elastic;
    const T &vx = in.v[0].x(), &vy = in.v[0].y();
    const T speed = sqrt(vx * vx + vy * vy + in.parameter[4] * in.parameter[4]);
    const T drag = in.parameter[1] * normal_force / speed;
    out->force[0].x() -= drag * vx;
    out->force[0].y() -= drag * vy;
    out->force[0].z() += normal_force;
  }

  // Of the push without damping, A k (d - g)^3 / (3 d).
  static double Energy(const Element& element, const ElementInput<GroundContact, double>& in) {
    const double distance = in.parameter[3];
    const double depth = std::max(0.0, distance - (in.x[0].z() - element.height));
    return element.area * in.parameter[0] * depth * depth * depth / (3.0 * distance);
  }
};

}  // namespace clothfit
