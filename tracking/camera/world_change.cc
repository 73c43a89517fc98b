// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/world_change.h"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {

WorldChange TurnUp(const std::string& axis, double scale) {
  if (!(std::isfinite(scale) && scale > 0.0)) {
    throw InputError("--scale", fmt::format("expected a number above 0, found {}", scale));
  }
  const bool negative = axis.size() == 2 && axis[0] == '-';
  const std::string letter = negative ? axis.substr(1) : axis;
  if (letter != "x" && letter != "y" && letter != "z") {
    throw InputError("--up", fmt::format("expected x, y, z, -x, -y or -z, found '{}'", axis));
  }
  const Eigen::Vector3d up = (negative ? -1.0 : 1.0) * Eigen::Vector3d::Unit(letter[0] - 'x');
  WorldChange change;
  change.scale = scale;
  change.world_from_calibration =
      Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  // Axes go onto axes, so every entry is a whole number.
  change.world_from_calibration = change.world_from_calibration.array().round();
  return change;
}

WorldChange ParseSimilarity(const std::string& option, const std::vector<double>& numbers) {
  constexpr double kTolerance = 1e-4;
  if (numbers.size() != 16) {
    throw InputError(option, fmt::format("expected 16 numbers, found {}", numbers.size()));
  }
  const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) {
    throw InputError(option, "expected finite numbers that end in 0 0 0 1");
  }
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  WorldChange change;
  change.scale = std::cbrt(linear.determinant());
  if (!(change.scale > 0.0)) {
    throw InputError(option, fmt::format("expected a rotation times a scale, found determinant {}",
                                         linear.determinant()));
  }
  change.world_from_calibration = linear / change.scale;
  const Eigen::Matrix3d deviation =
      change.world_from_calibration * change.world_from_calibration.transpose() -
      Eigen::Matrix3d::Identity();
  if (deviation.cwiseAbs().maxCoeff() > kTolerance) {
    throw InputError(option,
                     fmt::format("expected a rotation times a scale, found it off by {:.2g}",
                                 deviation.cwiseAbs().maxCoeff()));
  }
  change.translation = matrix.topRightCorner<3, 1>();
  return change;
}

Camera InWorld(Camera camera, const WorldChange& change) {
  // x_camera = R x_calibration + t, both sides times the scale, and x_calibration put through the
  // inverse of the change.
  const Eigen::Matrix3d rotation =
      camera.camera_from_world_rotation * change.world_from_calibration.transpose();
  camera.camera_from_world_translation =
      change.scale * camera.camera_from_world_translation - rotation * change.translation;
  camera.camera_from_world_rotation = rotation;
  return camera;
}

}  // namespace clothfit
