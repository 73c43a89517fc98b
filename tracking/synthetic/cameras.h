// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cameras of a synthetic recording.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"

namespace clothfit {

// Cameras cam0, cam1, ... of 640 x 480 px without distortion on a circle of `radius` m around
// `target` (m, world), a little above it, all looking at it with z upwards in the picture. A ball
// of a third of the radius fills the picture's height. The first stands at -y.
std::vector<Camera> MakeCameraRing(int count, const Eigen::Vector3d& target, double radius);

struct RoomCameras {
  int count = 7;                       // the last hangs below the ceiling, where there are two
  Eigen::Vector2i size = {640, 480};   // px
  std::array<double, 5> distortion{};  // k1, k2, p1, p2, k3
  double distance = 3.0;               // m, of those around, from the middle of what they look at
  double height = 2.0;                 // m above the floor, about
  double ceiling = 3.6;                // m above the floor
};

// Cameras cam0, cam1, ... around a region and `ceiling` above it, as those of Hasler et al. 2007:
// all look at its middle, and each has the focal length at which the region just fills its
// picture. `region` are points (m, world) that have to stay in view, `floor` is their ground's
// height (m).
std::vector<Camera> MakeRoomCameras(const RoomCameras& options,
                                    const std::vector<Eigen::Vector3d>& region, double floor);

}  // namespace clothfit
