// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/cloth_coordinates.h"

#include <cmath>

namespace clothfit {

ClothCoordinates::ClothCoordinates(const PlacedCloth& cloth)
    : mesh_(cloth.mesh), rays_(cloth.mesh.triangles) {
  rays_.MoveTo(cloth.x);
}

std::optional<Eigen::Vector2d> ClothCoordinates::At(const Camera& camera,
                                                    const Eigen::Vector2d& pixel,
                                                    double min_angle) const {
  const std::optional<Eigen::Vector3d> direction = PixelDirection(camera, pixel);
  if (!direction) return std::nullopt;
  const std::optional<SurfaceHit> hit = rays_.First(CameraCentre(camera), *direction);
  if (!hit || std::abs(hit->normal.dot(*direction)) < std::sin(min_angle)) return std::nullopt;
  return hit->on_surface.At(mesh_.uv);
}

}  // namespace clothfit
