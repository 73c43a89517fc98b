// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How crumpled a cloth is.
#pragma once

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

// Root mean square of the angles (rad) between the normals of triangles that share an edge, for
// particles at x (3N, m). 0 where it is flat.
double Roughness(const ClothMesh& mesh, const Eigen::VectorXd& x);

}  // namespace clothfit
