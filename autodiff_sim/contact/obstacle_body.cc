// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/obstacle_body.h"

#include <algorithm>

namespace clothfit {

RigidPose Obstacle::PoseAt(double time) const {
  const int last = static_cast<int>(path.size()) - 1;
  const double frame = std::clamp(time * frame_rate, 0.0, static_cast<double>(last));
  const int before = std::min(static_cast<int>(frame), std::max(0, last - 1));
  if (before == last) return path.back();
  return RigidMotion(path[before], path[before + 1]).At(frame - before);
}

Obstacle MakeBall(double radius) {
  Obstacle ball;
  ball.points = Eigen::Vector3d::Zero();
  ball.radius = radius;
  return ball;
}

Obstacle MakeBar(double radius, double half_length) {
  Obstacle bar;
  bar.points.resize(6);
  bar.points << 0.0, 0.0, -half_length, 0.0, 0.0, half_length;
  bar.features.edges = {{0, 1}};
  bar.features.triangles = {{0, 1, 1}};
  bar.radius = radius;
  return bar;
}

Obstacle MakeBoxObstacle(const Eigen::Vector3d& half_sides, double below) {
  Eigen::VectorXd points(24);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                               (i & 4) != 0 ? 1.0 : -1.0);
    points.segment<3>(3 * i) = half_sides.cwiseProduct(sign);
    if (sign.z() < 0.0) points[3 * i + 2] -= below;
  }
  Obstacle box = MakeMeshObstacle(points, {{0, 2, 1},
                                           {1, 2, 3},
                                           {4, 5, 6},
                                           {5, 7, 6},
                                           {0, 1, 4},
                                           {1, 5, 4},
                                           {2, 6, 3},
                                           {3, 6, 7},
                                           {0, 4, 2},
                                           {2, 4, 6},
                                           {1, 3, 5},
                                           {3, 7, 5}});
  box.half_sides = half_sides;
  return box;
}

Obstacle MakeMeshObstacle(const Eigen::VectorXd& points,
                          const std::vector<std::array<int, 3>>& triangles) {
  Obstacle mesh;
  mesh.points = points;
  mesh.features = FindFeatures(triangles);
  return mesh;
}

}  // namespace clothfit
