// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a membrane carries where wrinkles that are shorter than the mesh limit its compression. A
// piece of length h buckles under Euler's load per width
//   N = B (pi / h)^2,   B the bending stiffness of a plate, N m,
// and beyond it shortens by wrinkling. With E the strain and Q >= 0 the shortening that wrinkles
// take up, both symmetric 2 x 2, the energy per area is the least over Q of
//   1/2 (E + Q - Q_0) : C : (E + Q - Q_0) + N tr Q - mu log det Q,   Q_0 = mu / N:
// the relaxed energy of a tension field (Pipkin 1986; Steigmann 1990), whose wrinkles cost what
// Euler's load does along them, with a logarithmic barrier that makes it smooth. The stress is
// S = mu Q^-1 - N: no direction carries more compression than N, whatever its angle to the threads,
// and shear counts as the compression along the bias that it is. As h becomes small N grows as
// 1 / h^2, and S becomes that of the material; at E = 0 the stiffness is the material's for any N.
// Viscous stress is limited together with the elastic one. Wrinkles keep a small share of the
// material's stiffness, so that the cloth's equations stay well posed.
#pragma once

#include <array>
#include <cmath>

#include "autodiff_sim/base/scalar.h"

namespace clothfit {

constexpr double kBuckledShare = 0.02;      // of the material's stress, that wrinkles keep
constexpr double kBucklingRounding = 0.05;  // mu (k_warp + k_weft + 2 k_shear) / N^2

// N/m, Euler's load. `bending` is bending.stiffness, four times B; `stiffness` the membrane's, N/m,
// of which a share of 1e-4 keeps the load of a limp cloth above zero; spacing: h, m.
template <class T>
T BucklingLoad(const T& bending, const T& stiffness, double spacing) {
  constexpr double kPi2Over4 = 2.4674011002723395, kLeastStrain = 1e-4;
  return bending * (kPi2Over4 / (spacing * spacing)) + stiffness * kLeastStrain;
}

// Along one direction that is not sheared: the stiffness without wrinkles over that with them at no
// stress, and times Q_0 over N.
constexpr double kStiffening = 1.0 / (1.0 - 0.5 * kBucklingRounding);
constexpr double kSoftness = 0.5 * kBucklingRounding * kStiffening;

// Q / Q_0 there, the root q of kSoftness (q - 1) + 1 + stress = 1 / q; the stress of the material
// without wrinkles over N.
template <class T>
T BuckledLength(const T& stress) {
  using std::sqrt;
  const T b = 1.0 - kSoftness + stress;
  const T root = sqrt(b * b + 4.0 * kSoftness);
  return Value(b) > 0.0 ? T(2.0 / (b + root)) : T((root - b) / (2.0 * kSoftness));
}

// Tension per width (N/m) along one direction that is not sheared: of a membrane of that stiffness
// (N/m, above zero) at a strain, with a viscous stress (N/m).
template <class T>
T BuckledTension(const T& stiffness, const T& load, const T& strain, const T& viscous) {
  const T plain = stiffness * strain + viscous, stiff = plain * kStiffening;
  const T q = BuckledLength<T>(stiff / load);
  return (stiff + load * kSoftness * (q - 1.0)) * (1.0 - kBuckledShare) + plain * kBuckledShare;
}

// J/m^2, the energy of its elastic part.
double BuckledEnergy(double stiffness, double load, double strain);

// Q / Q_0 = [x z; z y] where the energy is least, for the stress of the material without wrinkles
// over N and its stiffness times Q_0 over N, along warp and weft and of shear (twice the shear
// stiffness).
struct Wrinkles {
  double x, y, z;
  double determinant;                            // x y - z^2, which may be tiny beside x y
  std::array<std::array<double, 3>, 3> inverse;  // of the equations' derivatives by x, y and z
};
Wrinkles FindWrinkles(const std::array<double, 3>& stress, const std::array<double, 3>& stiffness);

// Stress per width along warp and weft and of shear, N/m; or the strains that go with it, of shear
// the change of the angle.
template <class T>
using PlaneStress = std::array<T, 3>;

// What FindWrinkles asks for, and mu / N^2 (m/N).
template <class T>
struct Softened {
  PlaneStress<T> stress, stiffness;
  T softness;
};
template <class T>
Softened<T> Soften(const PlaneStress<T>& stiffness, const T& load, const PlaneStress<T>& strain,
                   const PlaneStress<T>& viscous) {
  Softened<T> out;
  out.softness = kBucklingRounding / (stiffness[0] + stiffness[1] + 2.0 * stiffness[2]);
  for (int i = 0; i < 3; ++i) {
    const T tangent = i < 2 ? stiffness[i] : T(2.0 * stiffness[2]);
    const T share = 1.0 / (1.0 - tangent * out.softness);
    out.stress[i] = (stiffness[i] * strain[i] + viscous[i]) * share / load;
    out.stiffness[i] = tangent * out.softness * share;
  }
  return out;
}

// Stress in the plane. stiffness: along warp and weft, of shear, N/m, the first two above zero.
template <class T>
PlaneStress<T> BuckledStress(const PlaneStress<T>& stiffness, const T& load,
                             const PlaneStress<T>& strain, const PlaneStress<T>& viscous) {
  const Softened<T> at = Soften<T>(stiffness, load, strain, viscous);
  const PlaneStress<T>&s = at.stress, &c = at.stiffness;
  const Wrinkles w = FindWrinkles({Value(s[0]), Value(s[1]), Value(s[2])},
                                  {Value(c[0]), Value(c[1]), Value(c[2])});
  // A step of Newton's method at the solution brings the derivatives along.
  const double d = w.determinant;
  const PlaneStress<T> g = {c[0] * (w.x - 1.0) + s[0] + (1.0 - w.y / d),
                            c[1] * (w.y - 1.0) + s[1] + (1.0 - w.x / d),
                            c[2] * w.z + s[2] + w.z / d};
  const std::array<double, 3> wrinkles = {w.x - 1.0, w.y - 1.0, w.z};
  PlaneStress<T> stress;
  for (int i = 0; i < 3; ++i) {
    const auto& row = w.inverse[i];
    const T q = wrinkles[i] - (row[0] * g[0] + row[1] * g[1] + row[2] * g[2]);
    stress[i] = load * (c[i] * q + s[i]) * (1.0 - kBuckledShare) +
                (stiffness[i] * strain[i] + viscous[i]) * kBuckledShare;
  }
  return stress;
}

// J/m^2, the energy of its elastic part.
double BuckledEnergy(const PlaneStress<double>& stiffness, double load,
                     const PlaneStress<double>& strain);

}  // namespace clothfit
