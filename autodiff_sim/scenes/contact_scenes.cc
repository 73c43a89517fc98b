// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/scenes/contact_scenes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "autodiff_sim/contact/obstacle_body.h"

namespace clothfit {
namespace {

constexpr double kOnGround = 0.0017;  // m, where the ground about bears a cloth's weight

// 0 until `begin` (s), 1 from `end` on, smooth between.
double Ramp(double time, double begin, double end) {
  const double s = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

ClothScene DroppedCloth(int n, double side) {
  ClothScene scene;
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

ClothScene FoldedCloth(int n, double side, double gap) {
  ClothScene scene;
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

ClothScene CornerDrawnOver(int n, double side) {
  ClothScene scene = LiftedCloth(n, side);
  const Eigen::Vector3d origin = scene.x.head<3>();
  scene.path = [origin, side](double time) {
    const double over = Ramp(time, 0.0, 1.0);
    const double height = 0.35 * side * Ramp(time, 0.0, 0.5) * (1.0 - Ramp(time, 0.5, 1.0));
    return std::vector<Eigen::Vector3d>{
        origin + Eigen::Vector3d(0.7 * side * over, 0.6 * side * over, height + 0.003 * over)};
  };
  return scene;
}

namespace {

ClothScene FlatCloth(int n, double side, double height) {
  ClothScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, height}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  return scene;
}

std::shared_ptr<const Obstacle> Place(Obstacle obstacle, const std::string& name,
                                      const std::vector<RigidPose>& path, double frame_rate) {
  obstacle.name = name;
  obstacle.path = path;
  obstacle.frame_rate = frame_rate;
  return std::make_shared<Obstacle>(obstacle);
}

}  // namespace

ClothScene ClothOverBall(int n, double side) {
  ClothScene scene = FlatCloth(n, side, 0.5 * side);
  scene.world.ground_height = 0.0;
  RigidPose pose;
  pose.origin_in_world = {0.53 * side, 0.48 * side, 0.27 * side};
  scene.world.obstacles = {Place(MakeBall(0.2 * side), "ball", {pose}, 0.0)};
  return scene;
}

ClothScene ClothOverBar(int n, double side) {
  ClothScene scene = FlatCloth(n, side, 0.4 * side);
  scene.world.ground_height = 0.0;
  RigidPose pose;
  pose.origin_in_world = {0.45 * side, 0.5 * side, 0.33 * side};
  pose.world_from_body = Eigen::AngleAxisd(1.56, Eigen::Vector3d::UnitX()).toRotationMatrix();
  scene.world.obstacles = {Place(MakeBar(0.05 * side, 0.7 * side), "bar", {pose}, 0.0)};
  scene.handles = LocateOnCloth(scene.mesh, {{side, 0.0}, {side, side}});
  const std::vector<Eigen::Vector3d> start = {scene.handles[0].At(scene.x),
                                              scene.handles[1].At(scene.x)};
  scene.path = [start, side](double time) {
    const double share = Ramp(time, 0.1, 1.1);
    const Eigen::Vector3d drawn(0.8 * side * share, 0.0, -0.2 * side * share);
    return std::vector<Eigen::Vector3d>{start[0] + drawn, start[1] + drawn};
  };
  return scene;
}

ClothScene TwistedCloth(int n, double side, double turns) {
  ClothScene scene = FlatCloth(n, side, 2.0 * side);
  scene.handles = LocateOnCloth(scene.mesh, {{0.0, 0.0}, {0.0, side}, {side, 0.0}, {side, side}});
  std::vector<Eigen::Vector3d> start;
  for (const SurfacePoint& handle : scene.handles) start.push_back(handle.At(scene.x));
  scene.path = [start, side, turns](double time) {
    std::vector<Eigen::Vector3d> places = start;
    const double share = Ramp(time, 0.0, 1.0), angle = 2.0 * M_PI * turns * share;
    for (int i = 0; i < 4; ++i) {
      const double arm = (i % 2 == 0 ? -0.5 : 0.5) * side, sign = i < 2 ? -0.5 : 0.5;
      // Half of the turn at each end.
      places[i] = {start[i].x() - sign * 0.5 * side * share,
                   0.5 * side + arm * std::cos(sign * angle),
                   2.0 * side + arm * std::sin(sign * angle)};
    }
    return places;
  };
  return scene;
}

ClothScene BoxIntoCloth(int n, double side) {
  ClothScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, side}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  scene.handles = LocateOnCloth(scene.mesh, {{0.0, 0.0}, {side, 0.0}});
  const std::vector<Eigen::Vector3d> start = {scene.handles[0].At(scene.x),
                                              scene.handles[1].At(scene.x)};
  scene.path = [start](double) { return start; };
  std::vector<RigidPose> path;
  for (int frame = 0; frame <= 30; ++frame) {
    RigidPose pose;
    pose.origin_in_world = {0.55 * side, (-0.3 + 0.02 * frame) * side, 0.4 * side};
    pose.world_from_body =
        Eigen::AngleAxisd(0.05 * frame, Eigen::Vector3d(0.36, 0.48, 0.8)).toRotationMatrix();
    path.push_back(pose);
  }
  const Eigen::Vector3d half = side * Eigen::Vector3d(0.12, 0.1, 0.15);
  scene.world.obstacles = {Place(MakeBoxObstacle(half), "box", path, 30.0)};
  return scene;
}

}  // namespace clothfit
