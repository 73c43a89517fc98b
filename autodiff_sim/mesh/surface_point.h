// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A point of the cloth's surface, at cloth coordinates (u, v), as weights of three particles.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

struct SurfacePoint {
  std::array<int, 3> nodes = {0, 0, 0};
  std::array<double, 3> weights = {1.0, 0.0, 0.0};  // sum to 1; outside the mesh one may be below 0

  // The point's place (m) for particles at x (3N, node after node).
  Eigen::Vector3d At(const Eigen::VectorXd& x) const {
    return weights[0] * x.segment<3>(3 * nodes[0]) + weights[1] * x.segment<3>(3 * nodes[1]) +
           weights[2] * x.segment<3>(3 * nodes[2]);
  }
  // Its (u, v) (m), with those of the particles.
  Eigen::Vector2d At(const std::vector<Eigen::Vector2d>& uv) const {
    return weights[0] * uv[nodes[0]] + weights[1] * uv[nodes[1]] + weights[2] * uv[nodes[2]];
  }
};

// Finds the triangle that holds each (u, v), m; for a point outside (measured coordinates may be
// off by a millimetre) the triangle that is nearest in (u, v), extrapolated. Weights within 1e-9 of
// 0 or 1 are set to it, so that a point on a particle is that particle.
std::vector<SurfacePoint> LocateOnCloth(const ClothMesh& mesh,
                                        const std::vector<Eigen::Vector2d>& uv);

}  // namespace clothfit
