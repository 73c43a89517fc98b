// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What drives a simulation from outside during one step.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/surface_point.h"

namespace clothfit {

// A point of the cloth that is held at a place.
struct HandleTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d position;  // m, world
};

// A point of the cloth that is attracted to a tracked point.
struct PointTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d position;  // m, world
};

// A point of the cloth that is attracted to a tracked ray, in Pluecker coordinates.
struct RayTarget {
  SurfacePoint on_cloth;
  Eigen::Vector3d direction;  // unit, world
  Eigen::Vector3d moment;     // m, point x direction
};

struct StepInputs {
  std::vector<HandleTarget> handles;
  std::vector<PointTarget> points;
  std::vector<RayTarget> rays;
  // Derivatives of the inputs with respect to the directions of a sensitivity: num_rows() x
  // directions, the handles' positions first (3 rows each), then the points' (3), then the rays'
  // direction and moment (6). Empty where the inputs depend on no direction.
  Eigen::MatrixXd directions;

  int first_point_row() const { return 3 * static_cast<int>(handles.size()); }
  int first_ray_row() const { return first_point_row() + 3 * static_cast<int>(points.size()); }
  int num_rows() const { return first_ray_row() + 6 * static_cast<int>(rays.size()); }
};

}  // namespace clothfit
