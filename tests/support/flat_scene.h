// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a flat textured cloth before a textured floor, by intersecting rays with two planes:
// nothing of clothfit's own but the camera, so that trackers are tested against something else.
#pragma once

#include <random>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "tracking/camera/camera.h"
#include "tracking/recording/recording.h"
#include "tracking/recording/surface/initial_placement.h"

namespace clothfit {

class FlatScene {
 public:
  // A cloth of this size (m) in the plane z = 0 for all placements near there, seen from above.
  explicit FlatScene(const Eigen::Vector2d& size = {0.8, 0.6});

  struct Lighting {
    double gain = 1.0;    // of everything
    double noise = 0.0;   // grey levels, one sigma
    double shadow = 1.0;  // share of the light that is left on the floor beside the cloth
    unsigned seed = 1;
  };
  // 8-bit BGR. The shadow is the cloth's outline moved by 8 cm along +x.
  cv::Mat Render(const Camera& camera, const FlatPlacement& cloth, const Lighting& lighting) const;
  cv::Mat RenderEmpty(const Camera& camera, const Lighting& lighting) const;
  // 255 where the pixel's centre shows the cloth.
  cv::Mat Mask(const Camera& camera, const FlatPlacement& cloth) const;

  static FlatPlacement Placement(const Eigen::Vector3d& origin, double turned = 0.0);
  // The cloth as a mesh there.
  PlacedCloth Place(const FlatPlacement& cloth) const;
  Eigen::Vector2d Project(const Camera& camera, const FlatPlacement& cloth,
                          const Eigen::Vector2d& uv) const;
  const Eigen::Vector2d& size() const { return size_; }

 private:
  Eigen::Vector2d size_;
  cv::Mat cloth_, floor_;  // 8-bit BGR textures, 2 mm and 5 mm a texel
};

// A camera of 320 x 240 px at `centre` (m) that looks at `target`.
Camera LookAt(const Eigen::Vector3d& centre, const Eigen::Vector3d& target, double focal = 300.0);

}  // namespace clothfit
