// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A cloth with smooth folds at chance, that hides parts of itself.
#pragma once

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

struct CrumpledCloth {
  ClothMesh mesh;
  Eigen::VectorXd x;  // 3N, m, around (0.4, 0.3, 0)
};
// About 0.8 m x 0.6 m, folds up to `height` m high.
CrumpledCloth Crumple(unsigned seed, double height = 0.15, int resolution = 13);

}  // namespace clothfit
