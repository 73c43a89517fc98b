// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where rays meet a triangulated surface (Embree finds the triangle, double precision the place).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/surface_point.h"

namespace clothfit {

struct SurfaceHit {
  int triangle = 0;  // index into the triangles
  SurfacePoint on_surface;
  double distance = 0.0;   // m along the ray
  Eigen::Vector3d normal;  // unit, world, of the triangle as it goes round
};

// A surface that rays are cast at, hit from both sides. Calls to const functions may run at the
// same time.
class SurfaceRays {
 public:
  explicit SurfaceRays(std::vector<std::array<int, 3>> triangles);
  ~SurfaceRays();
  SurfaceRays(SurfaceRays&&) noexcept;

  // Particles at x (3N, m, world). Before the first call nothing is hit.
  void MoveTo(const Eigen::VectorXd& x);

  // The first place that a ray from `origin` (m, world) along `direction` (any length but zero)
  // meets, at least `near` m away.
  std::optional<SurfaceHit> First(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                  double near = 0.0) const;

  // Whether something lies between two points (m, world), leaving out `margin` m at the second,
  // which may itself lie on the surface.
  bool IsBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  std::vector<std::array<int, 3>> triangles_;
  Eigen::VectorXd x_;
};

}  // namespace clothfit
