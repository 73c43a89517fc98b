// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cloth's material: a triangle mesh in cloth coordinates, and what the force terms read off it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// A triangle mesh in cloth coordinates (u, v), metres, u along the warp and v along the weft. The
// cloth at rest is this flat shape.
struct ClothMesh {
  std::vector<Eigen::Vector2d> uv;            // m, one per particle
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise in (u, v)
  std::array<int, 2> grid = {0, 0};  // particles along u and v where the mesh is a grid, else 0
  // Whether the cloth buckles in wrinkles that are shorter than the mesh (term/buckling.h); else it
  // resists compression as it does tension.
  bool buckles = false;

  int num_particles() const { return static_cast<int>(uv.size()); }
  bool is_grid() const { return grid[0] > 0; }
};

// A rectangular grid over [0, size[0]] x [0, size[1]] m with resolution[0] x resolution[1]
// particles, at least 2 x 2 (else throws InputError); particle (i, j) has the index i + j *
// resolution[0]. Diagonals alternate, so that neither bias direction is preferred.
//
// Lines of the grid, else evenly spaced, go through the points of `through` (u, v, m), so that
// there are particles there: cloth that is held between its particles is held wrongly. A line stays
// where it is if it would have to go to where another one goes, or leave cells that are thinner
// than 0.4 of the even ones.
ClothMesh MakeGrid(const Eigen::Vector2d& size, const std::array<int, 2>& resolution,
                   const std::vector<Eigen::Vector2d>& through = {});

// m^2 in (u, v) of three particles, positive where they go round counter-clockwise.
double SignedArea(const ClothMesh& mesh, const std::array<int, 3>& particles);

struct RestTriangle {
  std::array<int, 3> nodes;
  double area;  // m^2
};
std::vector<RestTriangle> RestTriangles(const ClothMesh& mesh);

// Throws InputError, naming `source` and the triangle, where an index is out of range, a coordinate
// is not finite, a triangle is degenerate in (u, v) or turned over, an edge has more than two
// triangles or both on one side, or a particle has none.
void ValidateMesh(const ClothMesh& mesh, const std::string& source);

// A spring between two particles. Its spring constant is the membrane stiffness (N/m) times weight.
struct Spring {
  std::array<int, 2> nodes;
  double rest_length;            // m
  double weight;                 // width that the spring stands for / its length, no unit
  double warp_share = 0.0;       // squared cosine of its angle to the warp
  double buckling_length = 0.0;  // m, of the wrinkles that it may have; 0: it never buckles
};

// Two triangles that share an edge: nodes[0], nodes[1] are the opposite particles and nodes[2],
// nodes[3] the edge's, in the order of Bridson, Marino and Fedkiw 2003, fig. 1.
struct Hinge {
  std::array<int, 4> nodes;
  double shape;  // share |E|^2 / (|N1| + |N2|) at rest, no unit
  double width;  // |E|, on a grid 3/4 share |E|, m: of the cloth that bends at it
};

// What the force terms read off the mesh, found once.
struct ClothTopology {
  std::vector<Spring> structural;  // along warp and weft
  std::vector<Spring> shear;       // along the bias
  std::vector<Hinge> hinges;       // one per inner edge
  std::vector<double> areas;       // m^2, a third of the triangles around each particle
  double mean_edge = 0.0;          // m
};

// On a grid: structural springs along the cells' sides and shear springs along both diagonals of
// each cell, with weights that make a cell's membrane stiffness and shear modulus those of the
// parameters, whatever the resolution; the shear springs stretch too, and on square cells add the
// shear stiffness to the membrane's and couple warp and weft by as much. On any other mesh every
// edge is a spring weighted by its area (Van Gelder 1998) and shared between structural and shear
// by cos^2 and sin^2 of twice its angle to the warp.
//
// A hinge's share is 1, but on a grid, with s = |E|^2 / (|N1| + |N2|), it is 8 / (9 - 12 s^2) for
// the sides of cells and 2 / (3 s^2) for diagonals: 4/3 and 2/3 on square cells. Then a grid is an
// isotropic plate, with bending.stiffness four times its bending stiffness, after the particles at
// which diagonals end have moved against the others by what bending makes of them. Isotropic are
// cells whose sides are as 1 to 1.5 or nearer (docs/adr/0036-a-grid-is-an-isotropic-plate.md).
ClothTopology BuildTopology(const ClothMesh& mesh);

}  // namespace clothfit
