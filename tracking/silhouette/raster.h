// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The silhouette of a triangle mesh in a camera, exact to the pixel: a pixel belongs to it if the
// ray through its centre meets a triangle, edges included (Hasler et al. 2007, sec. 5: S_s).
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/silhouette/bit_mask.h"

namespace clothfit {

class SilhouetteRaster {
 public:
  SilhouetteRaster(const Camera& camera, std::vector<std::array<int, 3>> triangles);

  // Particles at x (3N, m, world). `mask` gets the camera's size. What lies behind the camera, also
  // the part of a triangle that does, is not seen. Calls may run at the same time.
  void Draw(const Eigen::VectorXd& x, BitMask* mask) const;

  const Camera& camera() const { return camera_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

 private:
  // For each side of a triangle, the plane through it and the camera's centre, so that a pixel
  // whose ray is d lies on the triangle's side where sign * normal . d >= 0. Neighbours share their
  // sides' planes exactly: no pixel falls through between them.
  struct Triangle {
    std::array<Eigen::Vector3d, 3> normals;
    std::array<double, 3> signs;
    double volume = 0.0;  // of the tetrahedron with the camera's centre, times six
  };
  struct Box {
    int left, right, top, bottom;  // px, inclusive
  };

  Eigen::Vector2d Normalised(int x, int y) const;
  bool Covers(const Triangle& triangle, const Eigen::Vector2d& normalised) const;
  Triangle Prepare(const std::array<int, 3>& nodes, const Eigen::Matrix3Xd& in_camera) const;
  bool FindBox(const std::array<int, 3>& nodes, const Eigen::Matrix3Xd& in_camera, Box* box) const;
  void DrawRow(const Triangle& triangle, int y, int left, int right, BitMask* mask) const;

  Camera camera_;
  std::vector<std::array<int, 3>> triangles_;
  bool is_distorted_;
  std::vector<Eigen::Vector2d> normalised_;  // of each pixel's centre, where the lens distorts
};

}  // namespace clothfit
