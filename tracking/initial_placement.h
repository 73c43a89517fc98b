// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the cloth is at frame 0.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "tracking/recording.h"

namespace clothfit {

// Positions (m, world) at frame 0 of points of the cloth (m, in (u, v)): on the plane of a flat
// placement, or on the thin-plate spline through the points of a point placement. Throws
// std::logic_error for a mesh, whose own vertices are the positions.
std::vector<Eigen::Vector3d> InitialPositions(const Recording& recording,
                                              const std::vector<Eigen::Vector2d>& uv);

}  // namespace clothfit
