// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cloth's surface at one moment, as a camera sees it.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/camera/camera.h"
#include "tracking/camera/surface_rays.h"

namespace clothfit {

// What a ray meets first.
struct SeenPoint {
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m, world
  double distance = 0.0;     // m along the ray
  Eigen::Vector3d facet;     // unit normal of the triangle, on the side of the ray's origin
  Eigen::Vector3d normal;    // unit normal interpolated between particles, of the same side
  SurfacePoint on_surface;
};

class ClothSurface {
 public:
  // The mesh must outlive it. Before MoveTo nothing is seen.
  explicit ClothSurface(const ClothMesh& mesh);

  // Particles at x (3N, m, world).
  void MoveTo(const Eigen::VectorXd& x);

  // Calls of these may run at the same time. The direction need not be of unit length.
  std::optional<SeenPoint> First(const Eigen::Vector3d& origin,
                                 const Eigen::Vector3d& direction) const;
  // Which point of the cloth the camera shows at a pixel; empty where it shows none.
  std::optional<SeenPoint> SeenAt(const Camera& camera, const Eigen::Vector2d& pixel) const;

  const Eigen::VectorXd& positions() const { return x_; }
  const SurfaceRays& rays() const { return rays_; }

 private:
  const ClothMesh& mesh_;
  SurfaceRays rays_;
  Eigen::VectorXd x_;
  Eigen::Matrix3Xd normals_;  // of the particles, weighted by area, not of unit length
};

}  // namespace clothfit
