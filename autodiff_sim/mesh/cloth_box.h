// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

// The box around a cloth's (u, v), m. The mesh has at least one particle.
struct ClothBox {
  Eigen::Vector2d low, high;
};

inline ClothBox BoxOf(const ClothMesh& mesh) {
  ClothBox box{mesh.uv.front(), mesh.uv.front()};
  for (const Eigen::Vector2d& uv : mesh.uv) {
    box.low = box.low.cwiseMin(uv);
    box.high = box.high.cwiseMax(uv);
  }
  return box;
}

}  // namespace clothfit
