// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What drives a simulation from outside during one step.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/surface_point.h"

namespace clothfit {

// A point of the cloth that is held at a place.
struct HandleTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d position;  // m, world
};

// A point of the cloth that is attracted to a tracked point. Its motion is not damped where it is
// not known how the target moves.
struct PointTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d position;                 // m, world
  std::optional<Eigen::Vector3d> velocity;  // m/s, world
};

// A point of the cloth that is attracted to a tracked ray, in Pluecker coordinates; damped
// likewise.
struct RayTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d direction;  // unit, world
  Eigen::Vector3d moment;     // m, point x direction
  struct Rates {
    Eigen::Vector3d direction;  // 1/s, at right angles to the direction
    Eigen::Vector3d moment;     // m/s
  };
  std::optional<Rates> rates;
};

// A force per area on the cloth, from outside: given at the nodes of a grid over (u, v), bilinear
// between them and constant beyond its edges. Node (i, j) counts i along u and j along v and has
// the index i + j * nodes[0].
struct ForceGrid {
  Eigen::Vector2d low = {0.0, 0.0}, high = {0.0, 0.0};  // m, (u, v) of the first and last node
  std::array<int, 2> nodes = {0, 0};                    // along u and v, at least 2 each
  // N/m^2 of the cloth at rest, one a node: along the surface's normal, the warp and, at right
  // angles to both, the weft, as they stand in space at the step's end. Empty for no force at all.
  std::vector<Eigen::Vector3d> force;
};

struct StepInputs {
  std::vector<HandleTarget> handles;
  std::vector<PointTarget> points;
  std::vector<RayTarget> rays;
  ForceGrid residual_force;  // acts as much as residual_force.share says
  // Derivatives of the inputs with respect to the directions of a sensitivity: num_rows() x
  // directions, the handles' positions first (3 rows each), then the points' (3), then the rays'
  // direction and moment (6), then the grid's forces (3). Empty where the inputs depend on no
  // direction.
  Eigen::MatrixXd directions;

  int first_point_row() const { return 3 * static_cast<int>(handles.size()); }
  int first_ray_row() const { return first_point_row() + 3 * static_cast<int>(points.size()); }
  int first_force_row() const { return first_ray_row() + 6 * static_cast<int>(rays.size()); }
  int num_rows() const {
    return first_force_row() + 3 * static_cast<int>(residual_force.force.size());
  }
};

}  // namespace clothfit
