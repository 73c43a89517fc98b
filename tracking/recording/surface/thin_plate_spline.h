// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface through scattered points that bends least.
#pragma once

#include <Eigen/Core>

namespace clothfit {

// A map from the plane to space, f(p) = A p + b + sum_i w_i U(|p - p_i|) with U(r) = r^2 log r^2,
// that takes given values at given sites and minimises the bending energy of each coordinate. An
// affine map is reproduced exactly. Far from the sites it grows little faster than an affine map.
// Reference: Bookstein 1989, "Principal Warps: Thin-Plate Splines and the Decomposition of
// Deformations". Fitting costs the cube of the number of sites.
class ThinPlateSpline {
 public:
  // One site a column, at least three, no two alike and not all on one line; values likewise.
  // smoothing 0 goes through the values exactly; above 0 it trades fidelity for less bending (it is
  // a multiple of the kernel's own scale, so 1e-6 is tiny and 1 nearly a plane).
  // Throws std::invalid_argument when the sites do not determine the surface.
  ThinPlateSpline(const Eigen::Matrix2Xd& sites, const Eigen::Matrix3Xd& values,
                  double smoothing = 0.0);

  Eigen::Vector3d operator()(const Eigen::Vector2d& point) const;

 private:
  Eigen::Vector2d Normalise(const Eigen::Vector2d& point) const;

  Eigen::Vector2d centre_;
  double scale_;              // brings the sites to about unit size, for the sake of conditioning
  Eigen::Matrix2Xd sites_;    // normalised
  Eigen::MatrixX3d weights_;  // of the kernel at each site, then of 1, x, y
};

}  // namespace clothfit
