// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Does an edge meet a triangle? Decided exactly.
#pragma once

#include <array>

#include <Eigen/Core>

namespace clothfit {

// Whether the closed segment from edge[0] to edge[1] and the closed triangle have a common point;
// touching and lying in one plane count. The answer is that of exact arithmetic on the given
// numbers (m), for edges without length and triangles without area too, which are what remains of
// them.
bool EdgeMeetsTriangle(const std::array<Eigen::Vector3d, 2>& edge,
                       const std::array<Eigen::Vector3d, 3>& triangle);

}  // namespace clothfit
