// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic_cameras.h"

#include <cmath>
#include <string>

#include <Eigen/Geometry>

namespace clothfit {

std::vector<Camera> MakeCameraRing(int count, const Eigen::Vector3d& target, double radius) {
  constexpr double kTwoPi = 6.283185307179586;
  constexpr double kElevation = 0.3;  // of the radius
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const double angle = kTwoPi * (static_cast<double>(i) / count - 0.25);
    const Eigen::Vector3d centre =
        target + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), kElevation);
    const Eigen::Vector3d z = (target - centre).normalized();
    const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
    Camera camera;
    camera.name = "cam" + std::to_string(i);
    camera.width = 640;
    camera.height = 480;
    camera.fx = camera.fy = 720.0;
    camera.cx = 319.5;
    camera.cy = 239.5;
    camera.camera_from_world_rotation.row(0) = x.transpose();
    camera.camera_from_world_rotation.row(1) = z.cross(x).transpose();
    camera.camera_from_world_rotation.row(2) = z.transpose();
    camera.camera_from_world_translation = -camera.camera_from_world_rotation * centre;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace clothfit
