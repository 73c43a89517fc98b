// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The outline of a cloth's silhouette as pieces of the mesh's edges, so that it can be followed
// when the cloth moves.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/surface_point.h"
#include "tracking/camera/camera.h"
#include "tracking/silhouette/bit_mask.h"

namespace clothfit {

// An edge of a mesh with its one or two triangles.
struct MeshEdge {
  std::array<int, 2> nodes;
  std::array<int, 2> opposite;   // third particles of its triangles; -1 where there is none
  std::array<int, 2> triangles;  // -1 likewise
};
std::vector<MeshEdge> FindEdges(const std::vector<std::array<int, 3>>& triangles);

struct OutlinePiece {
  std::array<int, 2> nodes;               // of the edge
  std::array<double, 2> shares;           // of nodes[1], at the piece's ends
  std::array<Eigen::Vector2d, 2> pixels;  // the ends in the picture
  std::array<double, 2> depths;           // m, z in the camera's frame, of the ends
  Eigen::Vector2d outward;                // unit, px, away from the cloth
};

// Pieces no longer than `longest` (px) of the cloth's rim and of folds where it turns its other
// side to the camera, those only whose outward side shows nothing of the cloth. `covered`: the same
// cloth's silhouette. Cloth that lies beside the picture counts as unseen: there is outline too.
std::vector<OutlinePiece> FindOutline(const Camera& camera, const std::vector<MeshEdge>& edges,
                                      const std::vector<std::array<int, 3>>& triangles,
                                      const Eigen::VectorXd& x, const BitMask& covered,
                                      double longest = 4.0);

struct OutlinePoint {
  std::array<int, 2> nodes;
  double share = 0.0;     // of nodes[1]: the point on the cloth
  double distance = 0.0;  // px, signed: positive where the pixel lies outside of the outline
  Eigen::Vector2d side;   // unit, px, out of the outline there
};
// The outline's point nearest to a pixel; empty where there is no outline.
std::optional<OutlinePoint> NearestOnOutline(const std::vector<OutlinePiece>& outline,
                                             const Eigen::Vector2d& pixel);

}  // namespace clothfit
