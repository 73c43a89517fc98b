// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/cloud_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "autodiff_sim/base/parallel.h"
#include "fitting/scene/scene.h"

namespace clothfit {

using Eigen::Vector3d;

PointResidual DistanceToSurface(const ClosestOnMesh& surface,
                                const std::vector<std::array<int, 3>>& triangles,
                                const Eigen::VectorXd& x, const Vector3d& point) {
  const auto [triangle, closest] = surface.Find(point);
  const auto& [a, b, c] = triangles[triangle];
  const Vector3d corner = x.segment<3>(3 * a);
  const Vector3d normal =
      (x.segment<3>(3 * b) - corner).cross(x.segment<3>(3 * c) - corner).normalized();
  PointResidual residual;
  residual.point = {triangles[triangle], closest.weights};
  const bool is_inside = std::all_of(closest.weights.begin(), closest.weights.end(),
                                     [](double weight) { return weight > 0.0; });
  constexpr double kTouching = 1e-9;  // m; there the way to a boundary has no direction
  const bool is_along_normal = is_inside || closest.distance < kTouching;
  residual.value = is_along_normal ? normal.dot(closest.offset) : closest.distance;
  residual.slope = -(is_along_normal ? normal : closest.offset / closest.distance).transpose();
  return residual;
}

CloudResiduals::CloudResiduals(const Scene& scene, double coverage)
    : scene_(scene), coverage_(coverage), surface_(scene.mesh.triangles, scene.initial) {}

int CloudResiduals::Count(const CloudObservation& cloud) const {
  const int of_particles = coverage_ > 0.0 ? scene_.mesh.num_particles() : 0;
  return static_cast<int>(cloud.points.size()) + of_particles;
}

std::vector<PointResidual> CloudResiduals::OfPoints(const CloudObservation& cloud,
                                                    const Eigen::VectorXd& x) const {
  ClosestOnMesh surface = surface_;
  surface.MoveTo(x);
  std::vector<PointResidual> residuals(cloud.points.size());
  constexpr int kPiece = 64;
  const int count = static_cast<int>(residuals.size());
  ParallelFor((count + kPiece - 1) / kPiece, NumThreads(0), [&](int piece, int) {
    for (int i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i)
      residuals[i] = DistanceToSurface(surface, scene_.mesh.triangles, x, cloud.points[i]);
  });
  return residuals;
}

// Not in the picture, or behind points of the cloud, it need not be seen.
bool CloudResiduals::ShouldShow(const CloudObservation& cloud, const Vector3d& place) const {
  if (!cloud.camera) return true;
  const Camera& camera = scene_.recording.cameras[*cloud.camera];
  if (!IsInFront(camera, place) || !IsInImage(camera, ProjectPoint(camera, place))) return false;
  const Vector3d centre = CameraCentre(camera);
  const Vector3d ray = (place - centre).normalized();
  const double farthest = (place - centre).norm() - 2.0 * cloud.spacing;
  return std::none_of(cloud.points.begin(), cloud.points.end(), [&](const Vector3d& point) {
    const double along = ray.dot(point - centre);
    return along < farthest && (point - centre - along * ray).norm() < cloud.spacing;
  });
}

PointResidual CloudResiduals::OfParticle(const CloudObservation& cloud, const Eigen::VectorXd& x,
                                         int particle) const {
  PointResidual residual;
  residual.point.nodes = {particle, particle, particle};
  const Vector3d place = x.segment<3>(3 * particle);
  double least = std::numeric_limits<double>::infinity();
  Vector3d away = Vector3d::Zero();
  for (const Vector3d& point : cloud.points) {
    const double squared = (place - point).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    away = place - point;
  }
  const double distance = std::sqrt(least), gap = distance - 2.0 * cloud.spacing;
  if (gap <= 0.0 || !ShouldShow(cloud, place)) return residual;
  const double weight =
      std::sqrt(coverage_ * static_cast<double>(cloud.points.size()) / scene_.mesh.num_particles());
  residual.value = weight * gap;
  residual.slope = weight / distance * away.transpose();
  return residual;
}

void CloudResiduals::Evaluate(const CloudObservation& cloud, const Eigen::VectorXd& x,
                              std::vector<PointResidual>* residuals) const {
  const std::vector<PointResidual> of_points = OfPoints(cloud, x);
  residuals->insert(residuals->end(), of_points.begin(), of_points.end());
  if (coverage_ == 0.0) return;
  const std::size_t first = residuals->size();
  const int particles = scene_.mesh.num_particles();
  residuals->resize(first + particles);
  constexpr int kPiece = 64;
  ParallelFor((particles + kPiece - 1) / kPiece, NumThreads(0), [&](int piece, int) {
    for (int i = piece * kPiece; i < std::min(particles, (piece + 1) * kPiece); ++i)
      (*residuals)[first + i] = OfParticle(cloud, x, i);
  });
}

}  // namespace clothfit
