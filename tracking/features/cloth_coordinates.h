// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which point of the cloth a pixel shows, while the cloth's place is known.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/camera/surface_rays.h"
#include "tracking/recording/surface/initial_placement.h"

namespace clothfit {

class ClothCoordinates {
 public:
  explicit ClothCoordinates(const PlacedCloth& cloth);

  // (u, v), m, of the first point of the cloth on the ray through the pixel, so that what the cloth
  // itself hides is not taken for seen; empty where the ray meets no cloth, or meets it under an
  // angle of less than `min_angle` (rad), where half a pixel would be many millimetres.
  std::optional<Eigen::Vector2d> At(const Camera& camera, const Eigen::Vector2d& pixel,
                                    double min_angle = 0.1) const;

 private:
  ClothMesh mesh_;
  SurfaceRays rays_;
};

}  // namespace clothfit
