// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of the trials' second generator: an unstructured triangulation of a rectangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

struct FemMesh {
  std::vector<Eigen::Vector2d> uv;            // m
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
};

// Vertices of a grid of `cells`, those inside moved at random by up to a fifth of a cell, and
// diagonals drawn at random. Corners are vertices. size: m; cells: at least 1 each.
FemMesh MakeFemMesh(const Eigen::Vector2d& size, const Eigen::Vector2i& cells, std::uint64_t seed);

// Two triangles with a common edge: from `nodes[0]` to `nodes[1]`, opposite to it `nodes[2]` (on
// its left) and `nodes[3]`.
struct FemHinge {
  std::array<int, 4> nodes;
};
std::vector<FemHinge> HingesOf(const FemMesh& mesh);

// Of the triangles' areas, m^2, a third to each vertex.
std::vector<double> VertexAreas(const FemMesh& mesh);

double TriangleArea(const FemMesh& mesh, const std::array<int, 3>& nodes);  // m^2

}  // namespace clothfit
