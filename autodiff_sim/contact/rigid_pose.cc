// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/rigid_pose.h"

#include <Eigen/Geometry>

namespace clothfit {

Eigen::VectorXd PlaceInWorld(const RigidPose& pose, const Eigen::VectorXd& x_in_body) {
  Eigen::VectorXd x(x_in_body.size());
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    x.segment<3>(i) = pose.world_from_body * x_in_body.segment<3>(i) + pose.origin_in_world;
  }
  return x;
}

RigidMotion::RigidMotion(const RigidPose& start, const RigidPose& end)
    : start_(start), velocity_(end.origin_in_world - start.origin_in_world) {
  const Eigen::AngleAxisd turn(
      Eigen::Matrix3d(start.world_from_body.transpose() * end.world_from_body));
  angle_ = turn.angle();
  axis_ = turn.axis();
}

RigidPose RigidMotion::At(double t) const {
  const Eigen::AngleAxisd turn(t * angle_, axis_);
  return {start_.world_from_body * turn.toRotationMatrix(), start_.origin_in_world + t * velocity_};
}

}  // namespace clothfit
