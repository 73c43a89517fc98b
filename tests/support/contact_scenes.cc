// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/contact_scenes.h"

#include <algorithm>
#include <cmath>

namespace clothfit {
namespace {

constexpr double kOnGround = 0.0017;  // m, where the ground about bears a cloth's weight

// 0 until `begin` (s), 1 from `end` on, smooth between.
double Ramp(double time, double begin, double end) {
  const double s = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

TestScene DroppedCloth(int n, double side) {
  TestScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  scene.world.ground_height = 0.0;
  scene.x.resize(3 * scene.mesh.num_particles());
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const Eigen::Vector2d uv = scene.mesh.uv[i] / side;
    // Bent, and not the same from side to side, so that it falls to no side in particular.
    const double bend = 0.04 * std::sin(2.5 * M_PI * uv.y()) + 0.02 * std::sin(3.0 * uv.x());
    scene.x.segment<3>(3 * i) << side * uv.x(), side * bend, 0.01 + side * uv.y();
  }
  return scene;
}

TestScene FoldedCloth(int n, double side, double gap) {
  TestScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  scene.world.ground_height = 0.0;
  scene.x.resize(3 * scene.mesh.num_particles());
  // Half of a circle between two flat layers, along u.
  const double radius = 0.5 * gap, arc = M_PI * radius, flat = 0.5 * (side - arc);
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const double u = scene.mesh.uv[i].x(), v = scene.mesh.uv[i].y();
    const double angle = std::clamp((u - flat) / radius, 0.0, M_PI);
    const double beyond = std::max(0.0, u - flat - arc);
    scene.x.segment<3>(3 * i) << std::min(u, flat) + radius * std::sin(angle) - beyond, v,
        kOnGround + radius * (1.0 - std::cos(angle));
  }
  scene.handles = LocateOnCloth(scene.mesh, {{side, 0.0}, {side, side}});
  const std::vector<Eigen::Vector3d> start = {scene.handles[0].At(scene.x),
                                              scene.handles[1].At(scene.x)};
  scene.path = [start, side](double time) {
    const Eigen::Vector3d drawn(0.3 * side * Ramp(time, 0.1, 0.9), 0.0, 0.0);
    return std::vector<Eigen::Vector3d>{start[0] + drawn, start[1] + drawn};
  };
  return scene;
}

TestScene CornerDrawnOver(int n, double side) {
  TestScene scene = LiftedCloth(n, side);
  const Eigen::Vector3d origin = scene.x.head<3>();
  scene.path = [origin, side](double time) {
    const double over = Ramp(time, 0.0, 1.0);
    const double height = 0.35 * side * Ramp(time, 0.0, 0.5) * (1.0 - Ramp(time, 0.5, 1.0));
    return std::vector<Eigen::Vector3d>{
        origin + Eigen::Vector3d(0.7 * side * over, 0.6 * side * over, height + 0.003 * over)};
  };
  return scene;
}

}  // namespace clothfit
