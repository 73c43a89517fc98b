// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/cloth_surface.h"

#include <Eigen/Geometry>

namespace clothfit {

using Eigen::Vector3d;

ClothSurface::ClothSurface(const ClothMesh& mesh) : mesh_(mesh), rays_(mesh.triangles) {}

void ClothSurface::MoveTo(const Eigen::VectorXd& x) {
  x_ = x;
  rays_.MoveTo(x);
  normals_.setZero(3, mesh_.num_particles());
  for (const std::array<int, 3>& nodes : mesh_.triangles) {
    const Vector3d a = x.segment<3>(3 * nodes[0]);
    const Vector3d ab = x.segment<3>(3 * nodes[1]) - a, ac = x.segment<3>(3 * nodes[2]) - a;
    for (const int node : nodes) normals_.col(node) += ab.cross(ac);
  }
}

std::optional<SeenPoint> ClothSurface::First(const Vector3d& origin,
                                             const Vector3d& direction) const {
  const std::optional<SurfaceHit> hit = rays_.First(origin, direction);
  if (!hit) return std::nullopt;
  SeenPoint seen;
  seen.on_surface = hit->on_surface;
  seen.uv = hit->on_surface.At(mesh_.uv);
  seen.position = hit->on_surface.At(x_);
  seen.distance = hit->distance;
  seen.facet = hit->normal.dot(direction) <= 0.0 ? hit->normal : Vector3d(-hit->normal);
  Vector3d normal = Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    normal += hit->on_surface.weights[k] * normals_.col(hit->on_surface.nodes[k]);
  if (normal.dot(seen.facet) < 0.0) normal = -normal;
  const double length = normal.norm();
  seen.normal = length > 0.0 ? Vector3d(normal / length) : seen.facet;
  return seen;
}

std::optional<SeenPoint> ClothSurface::SeenAt(const Camera& camera,
                                              const Eigen::Vector2d& pixel) const {
  const std::optional<Vector3d> direction = PixelDirection(camera, pixel);
  if (!direction) return std::nullopt;
  return First(CameraCentre(camera), *direction);
}

}  // namespace clothfit
