// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/support.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "tracking/recording/surface/initial_placement.h"

namespace clothfit {
namespace {

struct BoundingSphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, world
  double radius = 0.0;                               // m
};

// m, how far a shape extends from its origin; of a mesh only its file knows.
double ReachOf(const BallShape& ball) { return ball.radius; }
double ReachOf(const BarShape& bar) { return bar.radius + 0.5 * bar.length; }
double ReachOf(const BoxShape& box) { return 0.5 * box.size.norm() + box.below; }
double ReachOf(const MeshShape&) { return std::numeric_limits<double>::infinity(); }

// Of the corners, which a fold or a wave hardly leaves.
BoundingSphere SphereOf(const Recording& recording) {
  const Eigen::Vector2d& size = recording.cloth.size;
  const std::vector<Eigen::Vector3d> corners =
      InitialPositions(recording, {{0.0, 0.0}, {size.x(), 0.0}, {0.0, size.y()}, size});
  BoundingSphere sphere;
  for (const Eigen::Vector3d& corner : corners) sphere.centre += 0.25 * corner;
  for (const Eigen::Vector3d& corner : corners)
    sphere.radius = std::max(sphere.radius, (corner - sphere.centre).norm());
  return sphere;
}

bool MayCatch(const ObstacleDescription& obstacle, const BoundingSphere& cloth,
              const Eigen::Vector3d& gravity) {
  if (obstacle.path.size() > 1) return true;
  const Eigen::Vector3d offset = obstacle.path.front().position - cloth.centre;
  const Eigen::Vector3d down = gravity.normalized();
  const double below = offset.dot(down), beside = (offset - below * down).norm();
  const double reach =
      cloth.radius + std::visit([](const auto& shape) { return ReachOf(shape); }, obstacle.shape);
  return beside <= reach && below >= -reach;
}

}  // namespace

std::string DescribeLackOfSupport(const Recording& recording) {
  if (!recording.handles.empty()) return "";
  if (!recording.obstacles.empty()) {
    if (std::holds_alternative<MeshPlacement>(recording.cloth.initial)) return "";
    const BoundingSphere cloth = SphereOf(recording);
    const auto may_catch = [&](const ObstacleDescription& obstacle) {
      return MayCatch(obstacle, cloth, recording.gravity);
    };
    if (std::any_of(recording.obstacles.begin(), recording.obstacles.end(), may_catch)) return "";
  }
  if (!recording.ground_height)
    return "there is neither a handle nor ground, nor an obstacle under the cloth: it falls freely";
  return "there is no handle, and no obstacle under the cloth: nothing moves it but its "
         "fall to the ground";
}

}  // namespace clothfit
