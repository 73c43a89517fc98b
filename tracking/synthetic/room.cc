// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/room.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothfit {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

Room MakeRoom(const Vector3d& middle, double scale) {
  Room room;
  room.centre = middle;
  room.half_width *= scale;
  room.lamp = middle + scale * room.lamp;
  room.lamp_distance *= scale;
  return room;
}

double RoomScale(const Vector2d& cloth_size) { return cloth_size.maxCoeff() / 1.4; }

double FloorHeight(const std::optional<double>& ground, double lowest, const Vector2d& cloth_size) {
  return ground ? *ground : lowest - 0.3 * cloth_size.maxCoeff();
}

double Irradiance(const Room& room, const Vector3d& point, const Vector3d& normal, bool is_lit) {
  // A little more light comes from above than off the floor.
  const double ambient = room.ambient * (0.8 + 0.2 * normal.z());
  if (!is_lit) return ambient;
  const Vector3d to_lamp = room.lamp - point;
  const double squared = to_lamp.squaredNorm();
  const double cosine = std::max(0.0, normal.dot(to_lamp)) / std::sqrt(squared);
  return ambient + room.lamp_strength * cosine * room.lamp_distance * room.lamp_distance / squared;
}

RoomPoint HitRoom(const Room& room, const Vector3d& origin, const Vector3d& direction) {
  RoomPoint hit;
  hit.distance = std::numeric_limits<double>::infinity();
  const auto try_plane = [&](int axis, double place, double side) {
    const double distance = (place - origin[axis]) / direction[axis];
    if (!(distance > 0.0) || distance >= hit.distance) return;
    hit.distance = distance;
    hit.normal = side * Vector3d::Unit(axis);
    hit.is_floor = axis == 2;
  };
  if (direction.z() < 0.0) try_plane(2, room.centre.z(), 1.0);
  for (const int axis : {0, 1}) {
    const double side = direction[axis] > 0.0 ? 1.0 : -1.0;
    try_plane(axis, room.centre[axis] + side * room.half_width, -side);
  }
  hit.position = origin + hit.distance * direction;
  return hit;
}

Vector3f RoomColour(const Room& room, const PlaneTexture& floor, const RoomPoint& point,
                    double footprint) {
  const Vector3d from_centre = point.position - room.centre;
  if (point.is_floor) return floor.At(Vector2d(from_centre.head<2>()), footprint);
  if (from_centre.z() < 0.12) return {0.3F, 0.34F, 0.4F};  // the skirting
  return {0.62F, 0.64F, 0.62F};
}

}  // namespace clothfit
