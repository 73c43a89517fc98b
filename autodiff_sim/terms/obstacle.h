// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Obstacles that no picture shows: a plane, a table with an edge, a sphere, a capsule (a bar with
// round ends). Each pushes the particles that are inside along its surface's normal, without
// friction, with a pressure that grows with the depth d and whose slope is continuous where contact
// begins,
//   pressure = stiffness d^2 / (2 s) for d < s, stiffness (d - s / 2) beyond,  s = 5 mm.
// Inside of a sphere or capsule of radius R, r from its middle or axis, the depth is taken for
// (R^2 - r^2) / (2 R) and the normal for r / R: to first order the same at the surface, and smooth
// in the middle, from where a normal of unit length would point in all directions.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"
#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {

// m; the pressure is this times the stiffness.
template <class T>
T SoftDepth(const T& depth) {
  constexpr double kSoft = 0.005;  // m
  if (Value(depth) <= 0.0) return T(0.0);
  if (Value(depth) < kSoft) return depth * depth * (0.5 / kSoft);
  return depth - 0.5 * kSoft;
}

// The push on a particle at `offset` from the middle of a ball, m.
template <class T>
Vector3<T> PushOfBall(const Vector3<T>& offset, const T& radius, const T& stiffness) {
  const T depth = (radius * radius - offset.dot(offset)) / (2.0 * radius);
  return offset * (stiffness * SoftDepth<T>(depth) / radius);
}

constexpr Parameter kObstacleStiffness = {"stiffness", "Pa/m", "pressure per depth", 0.0, 0.0,
                                          0.0,         1e8,    Scale::kLinear,       1e4};

struct AreaElement {
  std::array<int, 1> nodes;
  double area;  // m^2
};
std::vector<AreaElement> AreaElements(const TermContext& context);

struct ObstaclePlane : TermDefaults {
  static constexpr const char* kName = "obstacle_plane";
  static constexpr const char* kTitle = "unseen plane";
  static constexpr const char* kDoc = "an unseen plane, such as a table or a wall";
  static constexpr const char* kReference = "penalty contact";
  static constexpr std::array kTies = {Tie::kContact, Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kPrefersAxes = true;
  static constexpr std::array<Parameter, 4> kParameters = {{
      kObstacleStiffness,
      Shape({"height", "m", "of the plane above the world's origin, along its normal", 0.0, 0.0,
             -100.0, 100.0, Scale::kLinear, 0.3},
            Meaning::kAlongTilt, 0.1, 0.4),
      Shape({"angle_1", "rad", "tilt of the normal, which is up at 0, as in gravity_tilt", 0.0, 0.0,
             -3.2, 3.2, Scale::kLinear, 0.3},
            Meaning::kTilt, 0.0, M_PI / 2, -M_PI / 2),
      Shape({"angle_2", "rad", "tilt of the normal, which is up at 0, as in gravity_tilt", 0.0, 0.0,
             -3.2, 3.2, Scale::kLinear, 0.3},
            Meaning::kTilt, 0.0, M_PI / 2, -M_PI / 2),
  }};

  struct Element {
    std::array<int, 1> nodes;
    double area;  // m^2
    DownFrame frame;
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ObstaclePlane, T>& in,
                       ElementOutput<ObstaclePlane, T>* out) {
    const Vector3<T> down = TiltedDown<T>(element.frame, in.parameter[2], in.parameter[3]);
    const T depth = in.parameter[1] + down.dot(in.x[0]);
    const T push = in.parameter[0] * element.area * SoftDepth<T>(depth);
    for (int k = 0; k < 3; ++k) out->force[0][k] -= push * down[k];
  }
};

// With one straight edge, level across it, and a side that goes down from it without end. The table
// is to the left of the way from the edge's first point to its second, seen from above. Where a is
// the depth below the top and b that behind the side, the depth is a + b - sqrt(a^2 + b^2)
// (Rvachev's R-function of an intersection): next to either face the depth below that one, and
// smooth between.
struct ObstacleTable : TermDefaults {
  static constexpr const char* kName = "obstacle_table";
  static constexpr const char* kTitle = "unseen table";
  static constexpr const char* kDoc = "an unseen table with an edge";
  static constexpr const char* kReference = "penalty contact";
  static constexpr std::array kTies = {Tie::kContact, Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 7> kParameters = {{
      kObstacleStiffness,
      PlaceInWorld("x1", Meaning::kPlaceX, "one point of its edge"),
      PlaceInWorld("y1", Meaning::kPlaceY, "one point of its edge"),
      PlaceInWorld("z1", Meaning::kPlaceZ, "one point of its edge"),
      PlaceInWorld("x2", Meaning::kPlaceX, "another point of its edge"),
      PlaceInWorld("y2", Meaning::kPlaceY, "another point of its edge"),
      PlaceInWorld("z2", Meaning::kPlaceZ, "another point of its edge"),
  }};
  using Element = ObstaclePlane::Element;
  static std::vector<Element> Elements(const TermContext& context) {
    return ObstaclePlane::Elements(context);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ObstacleTable, T>& in,
                       ElementOutput<ObstacleTable, T>* out) {
    using std::sqrt;
    const std::array<T, 7>& p = in.parameter;
    const Vector3<T> first(p[1], p[2], p[3]);
    const Vector3<T> edge = Vector3<T>(p[4], p[5], p[6]) - first;
    const Eigen::Vector3d& down = element.frame.down;
    const Vector3<T> up(T(-down.x()), T(-down.y()), T(-down.z()));
    Vector3<T> over = edge.cross(up);
    const T across = over.dot(over);
    if (!(Value(across) > 0.0)) return;
    over = over * (1.0 / sqrt(across));
    Vector3<T> top = over.cross(edge);
    top = top * (1.0 / sqrt(top.dot(top)));
    const Vector3<T> below = first - in.x[0];
    const T a = below.dot(top), b = below.dot(over);
    if (!(Value(a) > 0.0 && Value(b) > 0.0)) return;
    const T r = sqrt(a * a + b * b);
    const T push = p[0] * element.area * SoftDepth<T>(a + b - r);
    out->force[0] += (top * (1.0 - a / r) + over * (1.0 - b / r)) * push;
  }
};

struct ObstacleSphere : TermDefaults {
  static constexpr const char* kName = "obstacle_sphere";
  static constexpr const char* kTitle = "unseen ball";
  static constexpr const char* kDoc = "an unseen ball";
  static constexpr const char* kReference = "penalty contact";
  static constexpr std::array kTies = {Tie::kContact, Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 5> kParameters = {{
      kObstacleStiffness,
      PlaceInWorld("x", Meaning::kPlaceX, "its middle"),
      PlaceInWorld("y", Meaning::kPlaceY, "its middle"),
      PlaceInWorld("z", Meaning::kPlaceZ, "its middle"),
      Shape({"radius", "m", "its radius", 0.1, 0.1, 0.005, 10.0, Scale::kLog, 2.0},
            Meaning::kNumber, 0.05, 0.2),
  }};
  using Element = AreaElement;
  static std::vector<Element> Elements(const TermContext& context) { return AreaElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ObstacleSphere, T>& in,
                       ElementOutput<ObstacleSphere, T>* out) {
    const std::array<T, 5>& p = in.parameter;
    const Vector3<T> offset = in.x[0] - Vector3<T>(p[1], p[2], p[3]);
    out->force[0] += PushOfBall<T>(offset, p[4], p[0] * element.area);
  }
};

struct ObstacleCapsule : TermDefaults {
  static constexpr const char* kName = "obstacle_capsule";
  static constexpr const char* kTitle = "unseen bar";
  static constexpr const char* kDoc = "an unseen bar with round ends";
  static constexpr const char* kReference = "penalty contact";
  static constexpr std::array kTies = {Tie::kContact, Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 8> kParameters = {{
      kObstacleStiffness,
      PlaceInWorld("x1", Meaning::kPlaceX, "one end of its axis"),
      PlaceInWorld("y1", Meaning::kPlaceY, "one end of its axis"),
      PlaceInWorld("z1", Meaning::kPlaceZ, "one end of its axis"),
      PlaceInWorld("x2", Meaning::kPlaceX, "the other end of its axis"),
      PlaceInWorld("y2", Meaning::kPlaceY, "the other end of its axis"),
      PlaceInWorld("z2", Meaning::kPlaceZ, "the other end of its axis"),
      Shape({"radius", "m", "its radius", 0.05, 0.05, 0.005, 10.0, Scale::kLog, 2.0},
            Meaning::kNumber, 0.02, 0.1),
  }};
  using Element = AreaElement;
  static std::vector<Element> Elements(const TermContext& context) { return AreaElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ObstacleCapsule, T>& in,
                       ElementOutput<ObstacleCapsule, T>* out) {
    const std::array<T, 8>& p = in.parameter;
    const Vector3<T> end(p[1], p[2], p[3]);
    const Vector3<T> axis = Vector3<T>(p[4], p[5], p[6]) - end, from_end = in.x[0] - end;
    // How far along the axis the nearest point of it is; an axis of no length is a ball's middle.
    const T along = axis.dot(from_end), square = axis.dot(axis);
    const bool before = Value(along) <= 0.0 || !(Value(square) > 0.0);
    const T share = before ? T(0.0) : Value(along) >= Value(square) ? T(1.0) : T(along / square);
    out->force[0] += PushOfBall<T>(from_end - axis * share, p[7], p[0] * element.area);
  }
};

}  // namespace clothfit
