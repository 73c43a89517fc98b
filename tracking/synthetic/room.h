// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The empty room of synthetic pictures: a tiled floor, four walls around it, one lamp, and cameras
// along the walls. The lamp's light and that which comes from everywhere are given such that a
// white surface on the floor below the lamp has about the brightness 1.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/synthetic/plane_texture.h"

namespace clothfit {

struct Room {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, world, on the floor
  double half_width = 5.0;                           // m, from there to the walls
  Eigen::Vector3d lamp{1.3, -0.9, 4.0};              // m, world
  double lamp_strength = 0.6;  // of the lamp at `lamp_distance`, on a surface that faces it
  double lamp_distance = 4.0;  // m
  double ambient = 0.4;        // from everywhere
};

// The room for a cloth that lies about `middle` (m, world, on the floor). Lengths grow with
// `scale`; at 1 it suits a cloth of 1.4 m.
Room MakeRoom(const Eigen::Vector3d& middle, double scale);

// That scale for a cloth of this size (m).
double RoomScale(const Eigen::Vector2d& cloth_size);
// Where the floor is (m): at the ground, or without one a little below the lowest point of a
// motion.
double FloorHeight(const std::optional<double>& ground, double lowest,
                   const Eigen::Vector2d& cloth_size);

// Light on a surface at `point` with the unit `normal`; `is_lit`: the lamp is not hidden from it.
double Irradiance(const Room& room, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                  bool is_lit);

// The floor or wall that a ray from inside the room meets.
struct RoomPoint {
  Eigen::Vector3d position, normal;  // m, world; unit, into the room
  double distance = 0.0;             // m; the direction's length counts as one
  bool is_floor = false;
};
RoomPoint HitRoom(const Room& room, const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction);

// Its colour (blue, green, red) without light, averaged over `footprint` m.
Eigen::Vector3f RoomColour(const Room& room, const PlaneTexture& floor, const RoomPoint& point,
                           double footprint);

}  // namespace clothfit
