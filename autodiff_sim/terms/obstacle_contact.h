// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Contact of the cloth with the obstacles of the recording: balls, bars, boxes and meshes, at rest
// or on a path. The force is that of the term `contact` (terms/self_contact.h), with the gap to the
// obstacle's surface and the velocity against the obstacle's closest point; the obstacle takes no
// notice of it. Where the cloth keeps clear of itself, the ground too is such an obstacle, in the
// lowest quarter of the distance in which the term `ground` acts and with that term's friction: the
// ground then gives way, but not by more than that distance.
#pragma once

#include <array>
#include <cmath>

#include "autodiff_sim/contact/closest_offset.h"
#include "autodiff_sim/contact/obstacle_contact.h"
#include "autodiff_sim/term/term.h"
#include "autodiff_sim/terms/barrier.h"

namespace clothfit {

// What places all obstacles a little elsewhere, as far as they were not measured better.
constexpr Parameter OfPlacement(const char* name, Meaning meaning, const char* doc,
                                Places places = Places::kObstacles) {
  return {name, "m", doc, 0.0, 0.0, -0.1, 0.1, Scale::kLinear, 0.01, meaning, {}, false, places};
}

struct ObstacleBarrier : TermDefaults {
  static constexpr const char* kName = "obstacle";
  static constexpr const char* kDoc = "contact with the recording's obstacles, with friction";
  static constexpr const char* kReference = "Li et al. 2020, eq. 6 and 24; Coulomb friction";
  static constexpr Role kRole = Role::kContact;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kContact, Tie::kWorld};
  static constexpr Needs kNeeds = Needs::kObstacles;
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr bool kFollowsContacts = true;
  static constexpr int kStiffness = 0, kThickness = 1, kFriction = 2, kSlipSpeed = 3, kShift = 4,
                       kGrowth = 7;
  // Of the ground's distance, in which the barrier acts.
  static constexpr double kGroundShare = 0.25;
  static constexpr std::array<Parameter, 8> kParameters = {{
      {"stiffness", "Pa", "pressure of the barrier at obstacles", 200.0, 0.0, 1.0, 1e6, Scale::kLog,
       10.0},
      {"thickness", "m", "distance from an obstacle at which contact begins", 0.002, 0.002, 1e-4,
       0.02, Scale::kLog, 2.0},
      Free({"friction", "1", "Coulomb's coefficient mu of cloth on obstacles", 0.3, 0.0, 0.0, 2.0,
            Scale::kLinear, 0.3}),
      {"slip_speed", "m/s", "speed below which friction sticks", 0.005, 0.005, 1e-5, 0.1,
       Scale::kLog, 3.0},
      OfPlacement("shift_x", Meaning::kVectorX,
                  "how far obstacles stand from where the recording says, along x"),
      OfPlacement("shift_y", Meaning::kVectorY, "the same, along y"),
      OfPlacement("shift_z", Meaning::kVectorZ, "the same, upwards"),
      OfPlacement("growth", Meaning::kNumber,
                  "by how much balls and bars are thicker than the recording says",
                  Places::kRoundObstacles),
  }};
  static constexpr std::array<const char*, 3> kReads = {"ground.distance", "ground.friction",
                                                        "ground.slip_speed"};

  using Element = ObstacleContact;
  static std::vector<Element> Elements(const TermContext& context) {
    return context.obstacles == nullptr ? std::vector<Element>() : *context.obstacles;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ObstacleBarrier, T>& in,
                       ElementOutput<ObstacleBarrier, T>* out) {
    if (element.is_ground) return AddGroundForce<T>(element, in, out);
    using std::sqrt;
    const Vector3<T> shift(in.parameter[kShift], in.parameter[kShift + 1],
                           in.parameter[kShift + 2]);
    const Vector3<T> none(T(0.0), T(0.0), T(0.0));
    const std::array<Vector3<T>, 4> x = Complete<T>(element, element.points, shift, in.x);
    const std::array<Vector3<T>, 4> v = Complete<T>(element, element.velocities, none, in.v);
    FourPoints plain;
    for (int i = 0; i < 4; ++i) plain[i] = {Value(x[i].x()), Value(x[i].y()), Value(x[i].z())};
    const ClosestOffset<T> closest = FindClosestOffset<T>(element.kind, plain, x);
    const T distance = sqrt(closest.offset.dot(closest.offset));
    const T radius = GrownRadius<T>(element.radius, in.parameter[kGrowth]);
    const T s = (distance - radius) / in.parameter[kThickness];
    if (!(Value(s) < 1.0)) return;
    T push = in.parameter[kStiffness] * element.area;  // N, k A m
    std::array<Vector3<T>, 4> force;
    force.fill(none);
    if (element.kind == PairKind::kEdgeEdge) {
      if (!(element.parallel > 0.0 && HasCross(plain))) return;
      const T energy = push * in.parameter[kThickness] * Barrier<T>(s);
      push = push * AddFadingForce<T>(x, element.parallel, energy, &force);
    }
    const T normal_force = push * BarrierSlope<T>(s);
    const Vector3<T> normal = closest.offset * (T(1.0) / distance);
    const std::array<T, 4>& w = closest.weights;
    const Vector3<T> sliding =
        Across<T>(v[0] * w[0] + v[1] * w[1] + v[2] * w[2] + v[3] * w[3], normal);
    const Vector3<T> push_and_drag =
        normal * normal_force +
        Friction<T>(sliding, in.parameter[kFriction] * normal_force, in.parameter[kSlipSpeed]);
    for (int i = 0; i < element.count; ++i) {
      const int slot = element.first + i;
      out->force[i] += force[slot] + push_and_drag * w[slot];
    }
  }

  static double Energy(const Element& element, const ElementInput<ObstacleBarrier, double>& in) {
    const double thickness =
        element.is_ground ? in.read[0] * kGroundShare : in.parameter[kThickness];
    const Eigen::Vector3d shift(in.parameter[kShift], in.parameter[kShift + 1],
                                in.parameter[kShift + 2]);
    const FourPoints x = Complete<double>(element, element.points, shift, in.x);
    const double gap = element.is_ground
                           ? in.x[0].z() - element.points[1].z()
                           : FindClosestOffset<double>(element.kind, x, x).offset.norm() -
                                 GrownRadius(element.radius, in.parameter[kGrowth]);
    const double s = gap / thickness;
    if (!(s < 1.0)) return 0.0;
    const double energy = in.parameter[kStiffness] * element.area * thickness * Barrier<double>(s);
    if (element.is_ground || element.kind != PairKind::kEdgeEdge) return energy;
    return element.parallel > 0.0 ? energy * Fading(x, element.parallel) : 0.0;
  }

  // Of the parameters of several terms, of which `first` is this one's first.
  static ObstacleChange Change(const Eigen::VectorXd& parameters, Eigen::Index first) {
    return {parameters.segment<3>(first + kShift), parameters[first + kGrowth]};
  }

 private:
  // The pair's four points, or their velocities: the obstacle's, shifted, with the cloth's in their
  // places.
  template <class T>
  static std::array<Vector3<T>, 4> Complete(const Element& element, const FourPoints& obstacle,
                                            const Vector3<T>& shift,
                                            const std::array<Vector3<T>, 3>& cloth) {
    std::array<Vector3<T>, 4> all;
    for (int i = 0; i < 4; ++i) all[i] = Constant<T>(obstacle[i]) + shift;
    for (int i = 0; i < element.count; ++i) all[element.first + i] = cloth[i];
    return all;
  }
  template <class T>
  static Vector3<T> Constant(const Eigen::Vector3d& value) {
    return Vector3<T>(T(value.x()), T(value.y()), T(value.z()));
  }
  static bool HasCross(const FourPoints& x) {
    return (x[1] - x[0]).cross(x[3] - x[2]).squaredNorm() > 0.0;
  }
  template <class T>
  static Vector3<T> Across(const Vector3<T>& v, const Vector3<T>& normal) {
    return v - normal * normal.dot(v);
  }
  template <class T>
  static Vector3<T> Friction(const Vector3<T>& sliding, const T& limit, const T& slip_speed) {
    using std::sqrt;
    return sliding * (-limit / sqrt(sliding.dot(sliding) + slip_speed * slip_speed));
  }

  template <class T>
  static void AddGroundForce(const Element& element, const ElementInput<ObstacleBarrier, T>& in,
                             ElementOutput<ObstacleBarrier, T>* out) {
    const T s = (in.x[0].z() - element.points[1].z()) / (in.read[0] * kGroundShare);
    if (!(Value(s) < 1.0)) return;
    const T normal_force = in.parameter[kStiffness] * element.area * BarrierSlope<T>(s);
    const Vector3<T> sliding(in.v[0].x(), in.v[0].y(), T(0.0));
    out->force[0] += Friction<T>(sliding, in.read[1] * normal_force, in.read[2]);
    out->force[0].z() += normal_force;
  }
};

}  // namespace clothfit
