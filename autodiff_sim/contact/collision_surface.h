// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh made ready for collision queries.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/cloth_mesh.h"
#include "autodiff_sim/contact/dop_tree.h"
#include "autodiff_sim/contact/mesh_features.h"

namespace clothfit {

template <int Planes = 14>
struct CollisionSurface {
  // A cloth, its tree built over its flat shape.
  explicit CollisionSurface(const ClothMesh& mesh);
  // Any mesh, its tree built over its shape at x (3N, m).
  CollisionSurface(const std::vector<std::array<int, 3>>& triangles, const Eigen::VectorXd& x);

  MeshFeatures features;
  DopTree<Planes> tree;  // refitted by every query
};

}  // namespace clothfit
