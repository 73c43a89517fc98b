// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an obstacle is.
#pragma once

#include <Eigen/Core>

namespace clothfit {

struct RigidPose {
  Eigen::Matrix3d world_from_body = Eigen::Matrix3d::Identity();  // a rotation
  Eigen::Vector3d origin_in_world = Eigen::Vector3d::Zero();      // m, of the body's frame
};

// The vertices of a mesh, x_in_body (3N, m), in the world.
Eigen::VectorXd PlaceInWorld(const RigidPose& pose, const Eigen::VectorXd& x_in_body);

// A motion from one pose to another, during a step from time 0 to 1: its origin goes straight, and
// it turns about one axis, by half a turn at most, at a constant rate.
class RigidMotion {
 public:
  RigidMotion(const RigidPose& start, const RigidPose& end);

  RigidPose At(double t) const;
  const Eigen::Vector3d& velocity() const { return velocity_; }  // m a step, of the origin
  double angle() const { return angle_; }                        // rad a step, 0 or more

 private:
  RigidPose start_;
  Eigen::Vector3d velocity_;
  double angle_;          // rad
  Eigen::Vector3d axis_;  // a unit vector
};

}  // namespace clothfit
