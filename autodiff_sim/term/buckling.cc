// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/term/buckling.h"

#include <cmath>

namespace clothfit {
namespace {

// X along one axis, the root of c x^2 + b x = w.
double Along(double b, double c, double w) {
  const double root = std::sqrt(b * b + 4.0 * c * w);
  return b > 0.0 ? 2.0 * w / (b + root) : (root - b) / (2.0 * c);
}

// The ratio z^2 / d as if the material were isotropic: then X shares the stress's axes.
double FirstGuess(const std::array<double, 3>& s, const std::array<double, 3>& c) {
  const double mean = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]);
  const double radius = std::sqrt(half * half + s[2] * s[2]);
  const double like = (0.5 * (c[0] + c[1]) * half * half + c[2] * s[2] * s[2]) / (radius * radius);
  const double b = 1.0 + mean - like;
  const double first = Along(b + radius, like, 1.0), second = Along(b - radius, like, 1.0);
  const double z = 0.5 * (first - second) * s[2] / radius;
  return std::abs(z) / std::sqrt(first * second);
}

// The inverse of C + K, K V = X^-1 V X^-1, in terms of X and its determinant, so that nothing
// cancels where X is nearly singular.
void Invert(const std::array<double, 3>& c, Wrinkles* w) {
  const double x = w->x, y = w->y, z = w->z, d = w->determinant, both = x * y + z * z;
  const double determinant = 1.0 + c[0] * x * x + c[1] * y * y + c[2] * both +
                             d * (c[0] * c[1] * both + c[2] * (c[0] * x * x + c[1] * y * y)) +
                             c[0] * c[1] * c[2] * d * d * d;
  const double scale = 1.0 / determinant, d3 = d * d * d;
  const double by_warp = scale * z * (x + c[1] * d * y), by_weft = scale * z * (y + c[0] * d * x);
  const double across = scale * z * z * (1.0 - c[2] * d);
  w->inverse = {{
      {scale * (x * x * (1.0 + c[2] * d) + c[1] * d * both + d3 * c[1] * c[2]), across,
       2.0 * by_warp},
      {across, scale * (y * y * (1.0 + c[2] * d) + c[0] * d * both + d3 * c[0] * c[2]),
       2.0 * by_weft},
      {by_warp, by_weft, scale * (both + d * (c[0] * x * x + c[1] * y * y) + d3 * c[0] * c[1])},
  }};
}

}  // namespace

Wrinkles FindWrinkles(const std::array<double, 3>& s, const std::array<double, 3>& c) {
  Wrinkles found;
  const double b0 = 1.0 + s[0] - c[0], b1 = 1.0 + s[1] - c[1], goal = std::abs(s[2]);
  // One unknown is left, t = z / sqrt(d), which grows with the shear: with w = 1 + t^2 = x y / d
  //   c_x x^2 + b_x x = w,  c_y y^2 + b_y y = w,  t (1 / sqrt(d) + c_z sqrt(d)) = |s_z|.
  double t = goal > 0.0 ? FirstGuess(s, c) : 0.0, low = 0.0, high = HUGE_VAL;
  constexpr int kMostIterations = 100;
  constexpr double kTolerance = 1e-13;
  for (int iteration = 0;; ++iteration) {
    const double w = 1.0 + t * t;
    found.x = Along(b0, c[0], w);
    found.y = Along(b1, c[1], w);
    const double d = found.x * found.y / w, root = std::sqrt(d);
    found.determinant = d;
    found.z = s[2] > 0.0 ? -t * root : t * root;
    if (t == 0.0 || iteration == kMostIterations) break;
    const double value = t * (1.0 / root + c[2] * root), error = std::log(goal / value);
    if (std::abs(error) < kTolerance) break;
    (error > 0.0 ? low : high) = t;
    const double d_slope =
        1.0 / (w + c[0] * found.x * found.x) + 1.0 / (w + c[1] * found.y * found.y) - 1.0 / w;
    const double slope = 1.0 + t * t * d_slope * (c[2] * d - 1.0) / (c[2] * d + 1.0);
    double next = t * std::exp(error / slope);
    if (!(next > low && next < high)) {
      next = high == HUGE_VAL ? 1e3 * t : low == 0.0 ? 1e-3 * t : std::sqrt(low * high);
    }
    t = next;
  }
  Invert(c, &found);
  return found;
}

namespace {

// J/m^2: that of the material and of the wrinkles, whose trace and determinant over those of Q_0
// are given, the trace less what it is at no stress; and the share that is kept of the energy
// without a limit.
double EnergyOf(double material, double load, double softness, double trace, double determinant,
                double plain) {
  const double of_wrinkles = load * load * softness * (trace - std::log(determinant));
  return (material + of_wrinkles) * (1.0 - kBuckledShare) + plain * kBuckledShare;
}

}  // namespace

double BuckledEnergy(double stiffness, double load, double strain) {
  const double stiff = stiffness * kStiffening, q = BuckledLength(stiff * strain / load);
  const double stress = load * (1.0 / q - 1.0);
  return EnergyOf(0.5 * stress * stress / stiff, load, 0.5 * kBucklingRounding / stiffness, q - 1.0,
                  q, 0.5 * stiffness * strain * strain);
}

double BuckledEnergy(const PlaneStress<double>& stiffness, double load,
                     const PlaneStress<double>& strain) {
  const Softened<double> at = Soften<double>(stiffness, load, strain, {0.0, 0.0, 0.0});
  const Wrinkles w = FindWrinkles(at.stress, at.stiffness);
  const double d = w.determinant;
  const std::array<double, 3> stress = {load * (w.y / d - 1.0), load * (w.x / d - 1.0),
                                        -load * w.z / d};
  double material = 0.0, plain = 0.0;
  for (int i = 0; i < 3; ++i) {
    plain += 0.5 * stiffness[i] * strain[i] * strain[i];
    const double tangent = i < 2 ? stiffness[i] : 2.0 * stiffness[2];
    if (tangent > 0.0)
      material += (i < 2 ? 0.5 : 1.0) * stress[i] * stress[i] * (1.0 / tangent - at.softness);
  }
  return EnergyOf(material, load, at.softness, w.x + w.y - 2.0, d, plain);
}

}  // namespace clothfit
