// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Laws without a name: short sums of features with coefficients, which a diagnosis learns where no
// other term explains what is missing. They do not depend on the frame of the observer: fields hang
// on the place in the world and the speed there, tensions on the cloth's own strain.
#pragma once

#include <cmath>

#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/obstacle.h"

namespace clothfit {

// Coefficients of resistances, which only take energy.
constexpr Parameter LawResistance(const char* name, const char* unit, const char* doc,
                                  double largest, double usual) {
  return {name, unit, doc, 0.0, 0.0, 0.0, largest, Scale::kLinear, usual};
}

constexpr Parameter LawCoefficient(const char* name, const char* unit, const char* doc,
                                   double largest, double usual) {
  return {name, unit, doc, 0.0, 0.0, -largest, largest, Scale::kLinear, usual};
}

// A force field in the world, to first order in place and velocity: per area
//   f = c + G (x - x_0) - b v.
struct LawField : TermDefaults {
  static constexpr const char* kName = "law_field";
  static constexpr const char* kTitle = "learned force field";
  static constexpr const char* kDoc =
      "a learned force field in the world, linear in place and speed";
  static constexpr const char* kReference = "Taylor's series to first order";
  static constexpr Role kRole = Role::kLaw;
  static constexpr Work kWork = Work::kMixed;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 1;
  static constexpr bool kInternal = false;
  static constexpr bool kPrefersAxes = true;
  static constexpr std::array<Parameter, 16> kParameters = {{
      LawCoefficient("c_x", "N/m^2", "force per area at the middle", 1e3, 0.5),
      LawCoefficient("c_y", "N/m^2", "force per area at the middle", 1e3, 0.5),
      LawCoefficient("c_z", "N/m^2", "force per area at the middle", 1e3, 0.5),
      LawCoefficient("g_xx", "N/m^3", "growth of the x component along x", 1e4, 3.0),
      LawCoefficient("g_xy", "N/m^3", "growth of the x component along y", 1e4, 3.0),
      LawCoefficient("g_xz", "N/m^3", "growth of the x component along z", 1e4, 3.0),
      LawCoefficient("g_yx", "N/m^3", "growth of the y component along x", 1e4, 3.0),
      LawCoefficient("g_yy", "N/m^3", "growth of the y component along y", 1e4, 3.0),
      LawCoefficient("g_yz", "N/m^3", "growth of the y component along z", 1e4, 3.0),
      LawCoefficient("g_zx", "N/m^3", "growth of the z component along x", 1e4, 3.0),
      LawCoefficient("g_zy", "N/m^3", "growth of the z component along y", 1e4, 3.0),
      LawCoefficient("g_zz", "N/m^3", "growth of the z component along z", 1e4, 3.0),
      LawResistance("drag", "kg/(m^2 s)", "b, resistance in all directions", 1e2, 0.3),
      PlaceInWorld("x", Meaning::kPlaceX, "the middle"),
      PlaceInWorld("y", Meaning::kPlaceY, "the middle"),
      PlaceInWorld("z", Meaning::kPlaceZ, "the middle"),
  }};
  using Element = AreaElement;
  static std::vector<Element> Elements(const TermContext& context) { return AreaElements(context); }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<LawField, T>& in,
                       ElementOutput<LawField, T>* out) {
    const auto& p = in.parameter;
    for (int i = 0; i < 3; ++i) {
      T f = p[i] - p[12] * in.v[0][i];
      for (int j = 0; j < 3; ++j) f += p[3 + 3 * i + j] * (in.x[0][j] - p[13 + j]);
      out->force[0][i] += f * element.area;
    }
  }
};

// Air whose velocity is linear in place, felt through the air drag as wind is (terms/wind.h):
//   w = w_0 + G (x - x_0).
struct LawAir : TermDefaults {
  static constexpr const char* kName = "law_air";
  static constexpr const char* kTitle = "learned motion of the air";
  static constexpr const char* kDoc = "a learned motion of the air, linear in place";
  static constexpr const char* kReference = "Taylor's series to first order; see wind";
  static constexpr Role kRole = Role::kLaw;
  static constexpr Work kWork = Work::kDrives;
  static constexpr std::array kTies = {Tie::kWorld};
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr bool kPrefersAxes = true;
  static constexpr std::array<Parameter, 15> kParameters = {{
      LawCoefficient("w_x", "m/s", "velocity at the middle", 30.0, 0.5),
      LawCoefficient("w_y", "m/s", "velocity at the middle", 30.0, 0.5),
      LawCoefficient("w_z", "m/s", "velocity at the middle", 30.0, 0.5),
      LawCoefficient("g_xx", "1/s", "growth of the x component along x", 300.0, 3.0),
      LawCoefficient("g_xy", "1/s", "growth of the x component along y", 300.0, 3.0),
      LawCoefficient("g_xz", "1/s", "growth of the x component along z", 300.0, 3.0),
      LawCoefficient("g_yx", "1/s", "growth of the y component along x", 300.0, 3.0),
      LawCoefficient("g_yy", "1/s", "growth of the y component along y", 300.0, 3.0),
      LawCoefficient("g_yz", "1/s", "growth of the y component along z", 300.0, 3.0),
      LawCoefficient("g_zx", "1/s", "growth of the z component along x", 300.0, 3.0),
      LawCoefficient("g_zy", "1/s", "growth of the z component along y", 300.0, 3.0),
      LawCoefficient("g_zz", "1/s", "growth of the z component along z", 300.0, 3.0),
      PlaceInWorld("x", Meaning::kPlaceX, "the middle"),
      PlaceInWorld("y", Meaning::kPlaceY, "the middle"),
      PlaceInWorld("z", Meaning::kPlaceZ, "the middle"),
  }};
  static constexpr std::array<const char*, 3> kReads = {"air_drag.normal", "air_drag.saturation",
                                                        "air_drag.tangential"};

  using Element = AirDrag::Element;
  static std::vector<Element> Elements(const TermContext& context) {
    return AirDrag::Elements(context);
  }

  template <class T>
  static void AddForce(const Element&, const ElementInput<LawAir, T>& in,
                       ElementOutput<LawAir, T>* out) {
    const auto& p = in.parameter;
    const Vector3<T> middle = (in.x[0] + in.x[1] + in.x[2]) * T(1.0 / 3.0);
    const Vector3<T> velocity = (in.v[0] + in.v[1] + in.v[2]) * T(1.0 / 3.0);
    Vector3<T> air;
    for (int i = 0; i < 3; ++i) {
      air[i] = p[i];
      for (int j = 0; j < 3; ++j) air[i] += p[3 + 3 * i + j] * (middle[j] - p[12 + j]);
    }
    const Vector3<T> force =
        AirDragForce<T>(in.x, velocity - air, in.read) - AirDragForce<T>(in.x, velocity, in.read);
    for (Vector3<T>& corner : out->force) corner += force;
  }
};

// Tension in the cloth along its directions at 0, 45, 90 and 135 degrees from the warp, per width
//   s = c + k e + m de/dt,  e the strain along the direction,
// and along both diagonals c and k in a band around the cloth's diagonal too, as a thread would
// have; of the triangles' mean deformation gradients. No net force, no net moment.
struct LawTension : TermDefaults {
  static constexpr const char* kName = "law_tension";
  static constexpr const char* kTitle = "learned tension";
  static constexpr const char* kDoc =
      "a learned tension in the cloth, linear in strain and its rate";
  static constexpr const char* kReference = "Taylor's series to first order";
  static constexpr Role kRole = Role::kLaw;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 16> kParameters = {{
      LawCoefficient("c_0", "N/m", "tension along the warp", 1e3, 0.3),
      LawCoefficient("k_0", "N/m", "stiffness along the warp", 1e4, 30.0),
      LawResistance("m_0", "N s/m", "viscosity along the warp", 1e3, 0.3),
      LawCoefficient("c_45", "N/m", "tension at 45 degrees", 1e3, 0.3),
      LawCoefficient("k_45", "N/m", "stiffness at 45 degrees", 1e4, 30.0),
      LawResistance("m_45", "N s/m", "viscosity at 45 degrees", 1e3, 0.3),
      LawCoefficient("c_90", "N/m", "tension along the weft", 1e3, 0.3),
      LawCoefficient("k_90", "N/m", "stiffness along the weft", 1e4, 30.0),
      LawResistance("m_90", "N s/m", "viscosity along the weft", 1e3, 0.3),
      LawCoefficient("c_135", "N/m", "tension at 135 degrees", 1e3, 0.3),
      LawCoefficient("k_135", "N/m", "stiffness at 135 degrees", 1e4, 30.0),
      LawResistance("m_135", "N s/m", "viscosity at 135 degrees", 1e3, 0.3),
      LawCoefficient("band_c_45", "N/m", "tension along the rising diagonal's band", 1e3, 1.0),
      LawCoefficient("band_k_45", "N/m", "stiffness along the rising diagonal's band", 1e4, 30.0),
      LawCoefficient("band_c_135", "N/m", "tension along the falling diagonal's band", 1e3, 1.0),
      LawCoefficient("band_k_135", "N/m", "stiffness along the falling diagonal's band", 1e4, 30.0),
  }};

  static constexpr int kDirections = 4;
  struct Element {
    std::array<int, 3> nodes;
    double area;  // m^2
    // Of each corner: the derivative of its share along each direction, 1/m.
    std::array<std::array<double, 3>, kDirections> along;
    std::array<double, 2> band;  // share of the rising and the falling diagonal's band here
  };
  static std::vector<Element> Elements(const TermContext& context);

  template <class T>
  static void AddForce(const Element& element, const ElementInput<LawTension, T>& in,
                       ElementOutput<LawTension, T>* out) {
    using std::sqrt;
    const auto& p = in.parameter;
    for (int d = 0; d < kDirections; ++d) {
      Vector3<T> stretch = Vector3<T>::Zero(), rate = Vector3<T>::Zero();
      for (int i = 0; i < 3; ++i) {
        stretch += in.x[i] * T(element.along[d][i]);
        rate += in.v[i] * T(element.along[d][i]);
      }
      const T length = sqrt(stretch.dot(stretch));
      const T strain = length - 1.0;
      T tension = p[3 * d] + p[3 * d + 1] * strain + p[3 * d + 2] * (stretch.dot(rate) / length);
      if (d % 2 == 1) {
        const int band = d / 2;
        tension += (p[12 + 2 * band] + p[13 + 2 * band] * strain) * element.band[band];
      }
      const T pull = tension * element.area / length;
      for (int i = 0; i < 3; ++i) out->force[i] -= stretch * (pull * element.along[d][i]);
    }
  }
};

}  // namespace clothfit
