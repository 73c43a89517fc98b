// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cameras of a synthetic recording.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "tracking/camera.h"

namespace clothfit {

// Cameras cam0, cam1, ... of 640 x 480 px without distortion on a circle of `radius` m around
// `target` (m, world), a little above it, all looking at it with z upwards in the picture. A ball
// of a third of the radius fills the picture's height. The first stands at -y.
std::vector<Camera> MakeCameraRing(int count, const Eigen::Vector3d& target, double radius);

}  // namespace clothfit
