// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The clouds and depth pictures of a recording, loaded one at a time when they are asked for, as
// points in m in the world.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "tracking/recording/recording.h"

namespace clothfit {

// clouds/000000.ply (.pcd, .csv) of a frame; empty where there is none, or no finite point. Throws
// InputError where the file cannot be read or a point lies beyond kFarthest.
std::vector<Eigen::Vector3d> LoadCloud(const Recording& recording, int frame);

// depth/CAMERA/000000.png of a frame: a point for each pixel whose depth is known (not 0), where
// the camera has a mask of the frame for those that it shows as cloth. Depth is measured along the
// camera's view. Throws InputError as LoadMask and LoadDepthPicture.
std::vector<Eigen::Vector3d> LoadDepth(const Recording& recording, int camera, int frame);

struct ThinnedPoints {
  std::vector<Eigen::Vector3d> points;
  double spacing = 0.0;  // m, edge of the cells
};
// One point of each cell of a grid in the world: of its points the middle one in their order, which
// knows nothing of their errors. The cells have an edge of `spacing` (m), or as much more as it
// takes to have at most `most` points.
ThinnedPoints ThinPoints(const std::vector<Eigen::Vector3d>& points, double spacing, int most);

}  // namespace clothfit
