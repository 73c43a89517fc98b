// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From the world in which cameras were calibrated to the recording's, which is in metres.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"

namespace clothfit {

// point_in_world = scale * world_from_calibration * point_in_calibration + translation
struct WorldChange {
  double scale = 1.0;  // m per unit of the calibration
  Eigen::Matrix3d world_from_calibration = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  // m
};

// The change that turns this axis of the calibration, "x" or "-y" for example, up to +z.
WorldChange TurnUp(const std::string& axis, double scale);

// From 16 numbers, a similarity of homogeneous coordinates row by row. Throws InputError, naming
// the option, where they are none.
WorldChange ParseSimilarity(const std::string& option, const std::vector<double>& numbers);

// The camera as it stands in the recording's world; `camera` has its pose, and its translation's
// unit, from the calibration.
Camera InWorld(Camera camera, const WorldChange& change);

}  // namespace clothfit
