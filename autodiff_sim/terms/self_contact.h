// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Contact of the cloth with itself. A vertex and a triangle, or two edges, whose distance g is
// below the thickness d push each other away with the barrier of Li et al. 2020 ("Incremental
// potential contact", eq. 6), written without units so that the stiffness k is a pressure:
//   E = k A d m(c) b(g / d),  b(s) = -(1 - s)^2 ln s.
// Its slope is continuous where contact begins and it is infinite where the features touch. A is
// the area of cloth that the pair stands for (ContactPair), so that a layer on a layer feels about
// the pressure k (-b'(g / d)) on any mesh. m fades out the force of edges that become parallel,
// where their closest points jump (ibid., sec. 4.4.1, eq. 24): c is the squared length of their
// cross product, m = c/e (2 - c/e) below e and 1 above.
//
// Friction is Coulomb's, regularised as on the ground: f = -mu N u / sqrt(|u|^2 + s^2), N the
// normal force of the same evaluation and u the tangential velocity between the closest points. It
// is taken relative to the rigid motion that fits the four particles best, and the force is what
// does the corresponding work, since a force pair at a distance would otherwise turn the cloth: so
// it has no net moment and takes no notice of a rotation.
#pragma once

#include <cmath>

#include "autodiff_sim/contact/closest_offset.h"
#include "autodiff_sim/contact/contact_pair.h"
#include "autodiff_sim/term/term.h"
#include "autodiff_sim/terms/barrier.h"

namespace clothfit {

// The turning part of a motion of four points of equal weight.
template <class T>
class PairRotation {
 public:
  explicit PairRotation(const std::array<Vector3<T>, 4>& x) {
    const Vector3<T> centre = (x[0] + x[1] + x[2] + x[3]) * T(0.25);
    T xx(0.0), yy(0.0), zz(0.0), xy(0.0), xz(0.0), yz(0.0);
    for (int i = 0; i < 4; ++i) {
      const Vector3<T> r = x[i] - centre;
      arm_[i] = r;
      xx += r.x() * r.x(), yy += r.y() * r.y(), zz += r.z() * r.z();
      xy -= r.x() * r.y(), xz -= r.x() * r.z(), yz -= r.y() * r.z();
    }
    // Columns of the tensor of inertia, and its inverse by cross products.
    const Vector3<T> a(yy + zz, xy, xz), b(xy, xx + zz, yz), c(xz, yz, xx + yy);
    rows_ = {b.cross(c), c.cross(a), a.cross(b)};
    const T determinant = a.dot(rows_[0]);
    for (Vector3<T>& row : rows_) row = row * (T(1.0) / determinant);
  }

  const Vector3<T>& arm(int i) const { return arm_[i]; }  // m, from the centre
  // inertia^-1 b.
  Vector3<T> Solve(const Vector3<T>& b) const {
    return Vector3<T>(rows_[0].dot(b), rows_[1].dot(b), rows_[2].dot(b));
  }
  // 1/s.
  Vector3<T> Velocity(const std::array<Vector3<T>, 4>& v) const {
    const Vector3<T> momentum =
        arm_[0].cross(v[0]) + arm_[1].cross(v[1]) + arm_[2].cross(v[2]) + arm_[3].cross(v[3]);
    return Solve(momentum);
  }

 private:
  std::array<Vector3<T>, 4> arm_;
  std::array<Vector3<T>, 3> rows_;  // of the inverse
};

struct SelfContact : TermDefaults {
  static constexpr const char* kName = "contact";
  static constexpr const char* kDoc = "contact of the cloth with itself, with Coulomb friction";
  static constexpr const char* kReference = "Li et al. 2020, eq. 6 and 24; Coulomb, regularised";
  static constexpr Role kRole = Role::kContact;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kContact};
  static constexpr int kNodes = 4;
  static constexpr bool kInternal = true;
  static constexpr bool kFollowsContacts = true;
  static constexpr int kStiffness = 0, kThickness = 1, kFriction = 2, kSlipSpeed = 3;
  static constexpr std::array<Parameter, 4> kParameters = {{
      {"stiffness", "Pa", "pressure of the barrier between layers", 200.0, 0.0, 1.0, 1e6,
       Scale::kLog, 10.0},
      {"thickness", "m", "distance of layers at which contact begins", 0.002, 0.002, 1e-4, 0.02,
       Scale::kLog, 2.0},
      {"friction", "1", "Coulomb's coefficient mu of cloth on cloth", 0.3, 0.0, 0.0, 2.0,
       Scale::kLinear, 0.3},
      {"slip_speed", "m/s", "speed below which friction sticks", 0.005, 0.005, 1e-5, 0.1,
       Scale::kLog, 3.0},
  }};

  using Element = ContactPair;
  static std::vector<Element> Elements(const TermContext& context) {
    return context.contacts == nullptr ? std::vector<Element>() : *context.contacts;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<SelfContact, T>& in,
                       ElementOutput<SelfContact, T>* out) {
    using std::log;
    using std::sqrt;
    FourPoints plain;
    for (int i = 0; i < 4; ++i) {
      plain[i] = {Value(in.x[i].x()), Value(in.x[i].y()), Value(in.x[i].z())};
    }
    const ClosestOffset<T> closest = FindClosestOffset<T>(element.kind, plain, in.x);
    const T gap = sqrt(closest.offset.dot(closest.offset));
    const T& thickness = in.parameter[kThickness];
    const T s = gap / thickness, open = T(1.0) - s;
    if (!(Value(open) > 0.0)) return;
    T push = in.parameter[kStiffness] * element.area;  // N, k A m
    const T log_s = log(s);
    if (element.kind == PairKind::kEdgeEdge) {
      const T energy = push * thickness * open * open * (-log_s);
      push = push * AddFadingForce<T>(in.x, element.parallel, energy, &out->force);
      if (!(element.parallel > 0.0 && HasCross(plain))) return;
    }
    const T normal_force = push * open * (open / s - 2.0 * log_s);
    const Vector3<T> normal = closest.offset * (T(1.0) / gap);
    for (int i = 0; i < 4; ++i) out->force[i] += normal * (normal_force * closest.weights[i]);
    AddFriction<T>(in, closest, normal, normal_force, out);
  }

  static double Energy(const Element& element, const ElementInput<SelfContact, double>& in) {
    const double thickness = in.parameter[kThickness];
    const double s = FindClosestOffset<double>(element.kind, in.x, in.x).offset.norm() / thickness;
    if (!(s < 1.0)) return 0.0;
    const double energy = in.parameter[kStiffness] * element.area * thickness * Barrier<double>(s);
    return element.kind == PairKind::kEdgeEdge ? energy * Fading(in.x, element.parallel) : energy;
  }

 private:
  // Whether the edges are not exactly parallel: else their force is 0, and so are its derivatives.
  static bool HasCross(const FourPoints& x) {
    return (x[1] - x[0]).cross(x[3] - x[2]).squaredNorm() > 0.0;
  }

  template <class T>
  static void AddFriction(const ElementInput<SelfContact, T>& in, const ClosestOffset<T>& closest,
                          const Vector3<T>& normal, const T& normal_force,
                          ElementOutput<SelfContact, T>* out) {
    using std::sqrt;
    const PairRotation<T> rotation(in.x);
    const std::array<T, 4>& w = closest.weights;
    const Vector3<T> relative = in.v[0] * w[0] + in.v[1] * w[1] + in.v[2] * w[2] + in.v[3] * w[3] -
                                rotation.Velocity(in.v).cross(closest.offset);
    const Vector3<T> sliding = relative - normal * normal.dot(relative);
    const T& slip = in.parameter[kSlipSpeed];
    const T drag =
        in.parameter[kFriction] * normal_force / sqrt(sliding.dot(sliding) + slip * slip);
    const Vector3<T> force = sliding * (-drag);
    const Vector3<T> turn = rotation.Solve(closest.offset.cross(force));
    for (int i = 0; i < 4; ++i) out->force[i] += force * w[i] - turn.cross(rotation.arm(i));
  }
};

}  // namespace clothfit
