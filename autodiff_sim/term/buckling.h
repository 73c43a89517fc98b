// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a thread carries where wrinkles that are shorter than the mesh limit its compression. A
// piece of length h buckles under Euler's load per width
//   N = B (pi / h)^2,   B the bending stiffness of a plate, N m,
// and beyond it shortens by wrinkling: the relaxed membrane of a tension field (Pipkin 1986;
// Steigmann 1990), whose wrinkles cost what Euler's load does along them. In tension the material's
// t = k e is as it is; in compression
//   t = k e / sqrt(1 + (k e / N)^2),
// which is never beyond N, with the energy N^2 / k (sqrt(1 + (k e / N)^2) - 1) per area: convex and
// twice continuously differentiable. As h becomes small N grows as 1 / h^2, and the tension becomes
// that of the material. Viscous tension is limited together with the elastic one. Wrinkles keep a
// small share of the material's stiffness, so that the cloth's equations stay well posed. It is the
// law of each spring along the threads, and of the two of a cell along the bias together
// (terms/shear.h).
#pragma once

#include <cmath>

#include "autodiff_sim/base/scalar.h"

namespace clothfit {

constexpr double kBuckledShare = 0.02;  // of the material's tension, that wrinkles keep

// N/m, Euler's load. `bending` is bending.stiffness, four times B; `stiffness` the membrane's, N/m,
// of which a share of 5e-4 keeps the load of a limp cloth above zero; spacing: h, m.
template <class T>
T BucklingLoad(const T& bending, const T& stiffness, double spacing) {
  constexpr double kPi2Over4 = 2.4674011002723395, kLeastStrain = 5e-4;
  return bending * (kPi2Over4 / (spacing * spacing)) + stiffness * kLeastStrain;
}

// Tension per width (N/m), for the tension (N/m) of the material without wrinkles and the load.
template <class T>
T BuckledTension(const T& plain, const T& load) {
  using std::sqrt;
  if (Value(plain) >= 0.0) return plain;
  const T share = plain / load;
  return plain * ((1.0 - kBuckledShare) / sqrt(1.0 + share * share) + kBuckledShare);
}

// J/m^2, its integral over the strain of a membrane of that stiffness, N/m.
inline double BuckledEnergy(double stiffness, double load, double strain) {
  const double plain = 0.5 * stiffness * strain * strain;
  if (strain >= 0.0) return plain;
  const double limited =
      load * load / stiffness * (std::hypot(1.0, stiffness * strain / load) - 1.0);
  return limited * (1.0 - kBuckledShare) + plain * kBuckledShare;
}

}  // namespace clothfit
