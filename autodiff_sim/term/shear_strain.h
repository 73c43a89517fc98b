// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The shear of a triangle: x_u . x_v, with x_u and x_v the derivatives of its place in space by its
// place in the cloth, which is the shear condition of Baraff and Witkin 1998, sec. 4.2, over the
// area. For small strains it is the change of the angle between warp and weft, rad; turning and
// moving leave it alone, and so does stretching along the threads.
#pragma once

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct ShearTriangle {
  std::array<int, 3> nodes;
  double area;                   // m^2, at rest
  std::array<double, 3> du, dv;  // 1/m: x_u = sum of du[i] x_i, x_v = sum of dv[i] x_i
};

std::vector<ShearTriangle> ShearTriangles(const ClothMesh& mesh);

template <class T, std::size_t kNodes>
Vector3<T> AlongCloth(const std::array<double, kNodes>& weights,
                      const std::array<Vector3<T>, kNodes>& x) {
  Vector3<T> sum;
  for (int k = 0; k < 3; ++k) {
    sum[k] = weights[0] * x[0][k];
    for (std::size_t i = 1; i < kNodes; ++i) sum[k] += weights[i] * x[i][k];
  }
  return sum;
}

template <class T>
T ShearStrain(const ShearTriangle& triangle, const std::array<Vector3<T>, 3>& x) {
  return AlongCloth<T>(triangle.du, x).dot(AlongCloth<T>(triangle.dv, x));
}

// Adds the forces of a shear stress (N/m) that resists positive shear: minus area times stress
// times the gradient of the shear.
template <class T>
void AddShearStress(const ShearTriangle& triangle, const std::array<Vector3<T>, 3>& x,
                    const T& stress, std::array<Vector3<T>, 3>* force) {
  const Vector3<T> x_u = AlongCloth<T>(triangle.du, x), x_v = AlongCloth<T>(triangle.dv, x);
  const T pull = stress * triangle.area;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      (*force)[i][k] -= pull * (triangle.du[i] * x_v[k] + triangle.dv[i] * x_u[k]);
  }
}

}  // namespace clothfit
