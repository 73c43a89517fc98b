// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A force per area over the cloth and over time, as a vector of numbers: hat functions over a grid
// of (u, v) times hat functions over time, three components each, in the cloth's own frame (see
// ForceGrid).
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "autodiff_sim/term/step_inputs.h"

namespace clothfit {

struct ForceLayout {
  Eigen::Vector2d low = {0.0, 0.0}, high = {1.0, 1.0};  // m, corners of the cloth in (u, v)
  std::array<int, 2> nodes = {4, 4};                    // along u and v, at least 2 each
  int num_knots = 2;                                    // in time, at least 2; the first at time 0
  int frames_per_knot = 1;
  double frame_rate = 1.0;  // Hz

  int num_nodes() const { return nodes[0] * nodes[1]; }
  int size() const { return 3 * num_nodes() * num_knots; }
  int per_knot() const { return 3 * num_nodes(); }
  double spacing() const { return frames_per_knot / frame_rate; }  // s between knots
  double KnotTime(int knot) const { return knot * spacing(); }     // s
  // Of the component 0 normal, 1 warp, 2 weft. Node (i, j) is i + j * nodes[0].
  int Index(int knot, int node, int component) const {
    return 3 * (knot * num_nodes() + node) + component;
  }
  Eigen::Vector2d NodePlace(int node) const;  // m, (u, v)

  // The knot before a time and the weight of the one after it; the end's beyond the ends.
  void KnotBefore(double time, int* knot, double* weight) const;
  // The force (N/m^2) at a time, of the vector `force` of size().
  ForceGrid At(const Eigen::VectorXd& force, double time) const;
  // The same at a place (m), bilinear: normal, warp and weft.
  Eigen::Vector3d At(const Eigen::VectorXd& force, double time, const Eigen::Vector2d& uv) const;

  // Factor L of the correlations LL' of a field whose correlation falls with the distance d as
  // (1 + a) exp(-a), a = sqrt(3) d / range (Matern 3/2: Rasmussen and Williams 2006, eq. 4.17),
  // over the cloth (range in m) and over time (s); components are independent. Lower triangular.
  Eigen::MatrixXd CorrelationFactor(double length, double time) const;
};

// A knot every `spacing` seconds, or as near to it as whole frames come, to the frame after the
// last or beyond.
ForceLayout MakeForceLayout(const ClothMesh& mesh, const std::array<int, 2>& nodes,
                            double frame_rate, int last_frame, double spacing);

// A triangle as it stands in space: columns normal, warp and weft, unit vectors in the world.
Eigen::Matrix3d TriangleFrame(const ClothMesh& mesh, const std::array<int, 3>& triangle,
                              const Eigen::VectorXd& x);

// What one node of the grid does to one triangle: its force (N) on it is `area` times the
// triangle's frame times the node's components.
struct NodeShare {
  std::array<int, 3> triangle;
  int node;
  double area;  // m^2 at rest, times the node's weight at the triangle's middle
};
std::vector<NodeShare> NodeShares(const ClothMesh& mesh, const ForceLayout& layout);

// The force of each triangle (N, world, 3 x triangles) at a time, with the cloth at x.
Eigen::Matrix3Xd TriangleForces(const ClothMesh& mesh, const ForceLayout& layout,
                                const Eigen::VectorXd& force, double time,
                                const Eigen::VectorXd& x);

}  // namespace clothfit
