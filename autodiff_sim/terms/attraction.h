// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Attraction of a point of the surface to a tracked point or to a tracked ray, Hasler et al. 2007,
// sec. 3 and 4.1. Each has a linear part, f ~ d, and a reciprocal part, f ~ 1 / d^2, bounded near
// zero by the radius r: |f| = k d / (d^2 + r^2)^(3/2). The ray's force is perpendicular to the ray.
// Where it is known how a target moves, the rate of the offset is damped, so that a point follows
// without ringing.
#pragma once

#include <cmath>
#include <optional>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// Adds the pull along `offset` (from the target to the surface point, m) to the three particles.
template <class T>
void AddAttraction(const std::array<double, 3>& weights, const T& linear, const T& reciprocal,
                   const T& radius, const Vector3<T>& offset, std::array<Vector3<T>, 3>* force) {
  using std::sqrt;
  const T softened = offset.dot(offset) + radius * radius;
  const T pull = linear + reciprocal / (softened * sqrt(softened));
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) (*force)[i][k] -= weights[i] * (pull * offset[k]);
  }
}

template <class T>
Vector3<T> SurfacePosition(const std::array<double, 3>& weights,
                           const std::array<Vector3<T>, 3>& x) {
  Vector3<T> p;
  for (int k = 0; k < 3; ++k)
    p[k] = weights[0] * x[0][k] + weights[1] * x[1][k] + weights[2] * x[2][k];
  return p;
}

// Adds the damping of the offset's rate (m/s) to the three particles.
template <class T>
void AddAttractionDamping(const std::array<double, 3>& weights, const T& damping,
                          const Vector3<T>& rate, std::array<Vector3<T>, 3>* force) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) (*force)[i][k] -= weights[i] * (damping * rate[k]);
  }
}

// Those of both attractions.
inline constexpr std::array<Parameter, 4> kAttractionParameters = {{
    {"linear", "N/m", "force per distance", 0.0, 0.0, 0.0, 1e4, Scale::kLinear, 10.0},
    {"reciprocal", "N m^2", "force times squared distance", 0.0, 0.0, 0.0, 1.0, Scale::kLinear,
     1e-3},
    {"radius", "m", "distance within which the reciprocal pull fades", 0.005, 0.005, 1e-4, 0.1,
     Scale::kLog, 2.0},
    {"damping", "N s/m", "force per velocity relative to a target whose velocity is known", 0.0,
     0.0, 0.0, 1e3, Scale::kLinear, 1.0},
}};

struct PointAttraction : TermDefaults {
  static constexpr const char* kName = "attraction_point";
  static constexpr const char* kDoc = "pull of surface points towards tracked points";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 3";
  static constexpr Role kRole = Role::kGuide;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr int kInputs = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 4> kParameters = kAttractionParameters;

  struct Element {
    std::array<int, 3> nodes;
    std::array<double, 3> weights;
    std::array<double, 3> input;  // target, m
    int first_input;
    std::optional<Eigen::Vector3d> velocity;  // the target's, m/s
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    if (context.inputs == nullptr) return elements;
    int row = context.inputs->first_point_row();
    for (const PointTarget& target : context.inputs->points) {
      const Eigen::Vector3d& p = target.position;
      elements.push_back({target.on_cloth.nodes,
                          target.on_cloth.weights,
                          {p.x(), p.y(), p.z()},
                          row,
                          target.velocity});
      row += kInputs;
    }
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<PointAttraction, T>& in,
                       ElementOutput<PointAttraction, T>* out) {
    Vector3<T> offset = SurfacePosition<T>(element.weights, in.x);
    for (int k = 0; k < 3; ++k) offset[k] -= in.input[k];
    AddAttraction<T>(element.weights, in.parameter[0], in.parameter[1], in.parameter[2], offset,
                     &out->force);
    if (!element.velocity) return;
    Vector3<T> rate = SurfacePosition<T>(element.weights, in.v);
    for (int k = 0; k < 3; ++k) rate[k] -= T((*element.velocity)[k]);
    AddAttractionDamping<T>(element.weights, in.parameter[3], rate, &out->force);
  }
};

struct RayAttraction : TermDefaults {
  static constexpr const char* kName = "attraction_ray";
  static constexpr const char* kDoc = "pull of surface points towards tracked rays";
  static constexpr const char* kReference = "Hasler et al. 2007, sec. 4.1";
  static constexpr Role kRole = Role::kGuide;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr int kInputs = 6;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 4> kParameters = kAttractionParameters;

  struct Element {
    std::array<int, 3> nodes;
    std::array<double, 3> weights;
    std::array<double, 6> input;  // direction (unit), moment (m)
    int first_input;
    std::optional<RayTarget::Rates> rates;
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    if (context.inputs == nullptr) return elements;
    int row = context.inputs->first_ray_row();
    for (const RayTarget& ray : context.inputs->rays) {
      const Eigen::Vector3d &d = ray.direction, &m = ray.moment;
      elements.push_back({ray.on_cloth.nodes,
                          ray.on_cloth.weights,
                          {d.x(), d.y(), d.z(), m.x(), m.y(), m.z()},
                          row,
                          ray.rates});
      row += kInputs;
    }
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<RayAttraction, T>& in,
                       ElementOutput<RayAttraction, T>* out) {
    const Vector3<T> p = SurfacePosition<T>(element.weights, in.x);
    const Vector3<T> direction(in.input[0], in.input[1], in.input[2]);
    const Vector3<T> moment(in.input[3], in.input[4], in.input[5]);
    // Hasler 2007, sec. 4.1: v points from the ray to the point.
    const Vector3<T> from_ray = (moment - p.cross(direction)).cross(direction);
    AddAttraction<T>(element.weights, in.parameter[0], in.parameter[1], in.parameter[2], from_ray,
                     &out->force);
    if (!element.rates) return;
    Vector3<T> turning, moving;
    for (int k = 0; k < 3; ++k) {
      turning[k] = T(element.rates->direction[k]);
      moving[k] = T(element.rates->moment[k]);
    }
    const Vector3<T> v = SurfacePosition<T>(element.weights, in.v);
    const Vector3<T> rate = (moving - v.cross(direction) - p.cross(turning)).cross(direction) +
                            (moment - p.cross(direction)).cross(turning);
    AddAttractionDamping<T>(element.weights, in.parameter[3], rate, &out->force);
  }
};

}  // namespace clothfit
