// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of the trials' second generator: an unstructured triangulation of a rectangle.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
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

// The discrete Laplacian at a vertex inside the mesh: the sum of weights times positions, with
// weights by the cotangents of the angles opposite to each edge, over the area nearest to the
// vertex (Pinkall and Polthier 1993; Meyer et al. 2003).
struct FemLaplacian {
  int vertex = 0;
  std::vector<std::pair<int, double>> weights;  // of vertices, itself included; no unit
  double area = 0.0;                            // m^2
};
std::vector<FemLaplacian> LaplaciansOf(const FemMesh& mesh);

// Of the triangles' areas, m^2, a third to each vertex.
std::vector<double> VertexAreas(const FemMesh& mesh);

double TriangleArea(const FemMesh& mesh, const std::array<int, 3>& nodes);  // m^2

}  // namespace clothfit
