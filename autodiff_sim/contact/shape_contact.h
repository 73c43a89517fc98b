// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Particles of the cloth against one obstacle shape: those that are close, and those that meet it
// during a step. Only particles are looked at, not what the cloth's edges and triangles cut off
// between them: a shape is meant to be large against a triangle. Else give its surface as a mesh.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/conservative_advancement.h"
#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/obstacle_shapes.h"

namespace clothfit {

struct ShapeContact {
  int particle;
  double distance;         // m, negative inside
  Eigen::Vector3d normal;  // the distance's gradient, in the world
};

// All particles at x (3N, m) whose signed distance is below `distance` (m), in order.
std::vector<ShapeContact> FindShapeProximity(const Eigen::VectorXd& x, const ObstacleShape& shape,
                                             const RigidPose& pose, double distance);

struct ShapeImpact {
  int particle;
  double time;  // in [0, 1] of the step, see Advance()
};

// When a point that moves straight from p0 to p1 (m) has met a moving shape, in [0, until].
std::optional<double> FirstShapeApproach(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                                         const ObstacleShape& shape, const RigidMotion& motion,
                                         const Approach& approach, double until = 1.0);

// All particles that meet the shape, in order. One that starts within the separation has time 0.
std::vector<ShapeImpact> FindShapeContinuous(const Motion& cloth_motion, const ObstacleShape& shape,
                                             const RigidMotion& motion, const Approach& approach);

// The smallest of their times, or 1.
double EarliestShapeImpact(const Motion& cloth_motion, const ObstacleShape& shape,
                           const RigidMotion& motion, const Approach& approach);

}  // namespace clothfit
