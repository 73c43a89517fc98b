// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the cloth is at frame 0.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// Positions (m, world) at frame 0 of points of the cloth (m, in (u, v)): on the plane of a flat
// placement, or on the thin-plate spline through the points of a point placement. Throws
// std::logic_error for a mesh, whose own vertices are the positions.
std::vector<Eigen::Vector3d> InitialPositions(const Recording& recording,
                                              const std::vector<Eigen::Vector2d>& uv);

// The cloth as a mesh, and where its particles are at frame 0.
struct PlacedCloth {
  ClothMesh mesh;
  Eigen::VectorXd x;  // 3N, m, world
};

// The recording's own mesh, or a grid of this many particles along u and v; 0 stands for as many as
// the recording says. Throws InputError where a mesh file cannot be used.
PlacedCloth PlaceCloth(const Recording& recording, const std::array<int, 2>& resolution = {0, 0});

}  // namespace clothfit
