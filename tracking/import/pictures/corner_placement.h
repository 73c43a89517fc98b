// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a flat sheet is, from points of it that were found in pictures.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// A point of the cloth, a corner for example, and where a camera sees it at frame 0.
struct SeenCorner {
  std::string camera;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();     // m
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  // px
};

struct SheetPlacement {
  FlatPlacement flat;              // its axes are orthonormal
  std::vector<std::string> notes;  // what each was placed by and how far it is off
};

// Points that two cameras or more see are triangulated. Three of them that are no line, or more,
// place the sheet (least squares, Umeyama 1991); two do if it hangs: straight down from them, along
// -z, with more of it below than above. Otherwise four points that one camera sees place it, by its
// size (cv::solvePnP, IPPE: Collins and Bartoli 2014).
//
// Throws InputError, naming --corner, on a camera or a point that does not exist, views that do not
// agree, and too few of them.
SheetPlacement PlaceByCorners(const std::vector<SeenCorner>& corners,
                              const std::vector<Camera>& cameras, const Eigen::Vector2d& size);

}  // namespace clothfit
