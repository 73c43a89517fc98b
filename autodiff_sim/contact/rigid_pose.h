// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an obstacle is.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clothfit {

struct RigidPose {
  Eigen::Matrix3d world_from_body = Eigen::Matrix3d::Identity();  // a rotation
  Eigen::Vector3d origin_in_world = Eigen::Vector3d::Zero();      // m, of the body's frame
};

// The vertices of a mesh, x_in_body (3N, m), in the world.
inline Eigen::VectorXd PlaceInWorld(const RigidPose& pose, const Eigen::VectorXd& x_in_body) {
  Eigen::VectorXd x(x_in_body.size());
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    x.segment<3>(i) = pose.world_from_body * x_in_body.segment<3>(i) + pose.origin_in_world;
  }
  return x;
}

// A motion from one pose to another, during a step from time 0 to 1: its origin goes straight, and
// it turns about one axis, by half a turn at most, at a constant rate.
class RigidMotion {
 public:
  RigidMotion(const RigidPose& start, const RigidPose& end)
      : start_(start),
        velocity_(end.origin_in_world - start.origin_in_world),
        turn_(Eigen::Matrix3d(start.world_from_body.transpose() * end.world_from_body)) {}

  RigidPose At(double t) const {
    const Eigen::AngleAxisd turn(t * turn_.angle(), turn_.axis());
    return {start_.world_from_body * turn.toRotationMatrix(),
            start_.origin_in_world + t * velocity_};
  }
  const Eigen::Vector3d& velocity() const { return velocity_; }  // m a step, of the origin
  double angle() const { return turn_.angle(); }                 // rad a step, 0 or more

 private:
  RigidPose start_;
  Eigen::Vector3d velocity_;
  Eigen::AngleAxisd turn_;
};

}  // namespace clothfit
