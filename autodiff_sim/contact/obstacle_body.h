// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A rigid obstacle of a scene: points, lines and triangles in a frame of its own, the body's, and
// everything within `radius` of them. A ball is a point, a bar with round ends is a line, a box and
// any other mesh are triangles of radius 0. It is at rest or follows a path.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/mesh_features.h"
#include "autodiff_sim/contact/rigid_pose.h"

namespace clothfit {

struct Obstacle {
  std::string name;
  Eigen::VectorXd points;  // 3M, m, in the body's frame
  // Features of the points. A line is an edge and, for the distance of a vertex from it, a triangle
  // without area.
  MeshFeatures features;
  double radius = 0.0;                          // m; 0 for a mesh
  Eigen::Vector3d half_sides{0.0, 0.0, 0.0};    // m, of a box; else 0
  std::vector<RigidPose> path = {RigidPose()};  // one pose a frame, or one for ever
  double frame_rate = 0.0;                      // Hz, of the path

  bool IsMesh() const { return radius == 0.0; }
  // Between frames it goes straight and turns about one axis; after the last it rests.
  RigidPose PoseAt(double time) const;
};

Obstacle MakeBall(double radius);                     // about the body's origin
Obstacle MakeBar(double radius, double half_length);  // along the body's z axis
// About the body's origin; its sides go on along -z by `below` (m).
Obstacle MakeBoxObstacle(const Eigen::Vector3d& half_sides, double below = 0.0);
Obstacle MakeMeshObstacle(const Eigen::VectorXd& points,
                          const std::vector<std::array<int, 3>>& triangles);

}  // namespace clothfit
