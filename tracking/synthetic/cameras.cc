// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/cameras.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// From `centre` to `target` (m, world), with `up` upwards in the picture.
void LookAt(const Vector3d& centre, const Vector3d& target, const Vector3d& up, Camera* camera) {
  const Vector3d z = (target - centre).normalized();
  const Vector3d x = z.cross(up).normalized();
  camera->camera_from_world_rotation.row(0) = x.transpose();
  camera->camera_from_world_rotation.row(1) = z.cross(x).transpose();
  camera->camera_from_world_rotation.row(2) = z.transpose();
  camera->camera_from_world_translation = -camera->camera_from_world_rotation * centre;
}

// The corners of the region as the lens shows it, in normalised coordinates.
Eigen::AlignedBox2d Extent(const Camera& camera, const std::vector<Vector3d>& region) {
  Eigen::AlignedBox2d extent;
  for (const Vector3d& point : region) {
    const Vector3d in_camera = CameraFromWorld<double>(camera, point);
    const Vector2d normalised = in_camera.head<2>() / std::max(in_camera.z(), 0.1);
    extent.extend(Distort<double>(camera.distortion, normalised));
  }
  return extent;
}

// Turns a camera at `centre` (m, world) so that the region is in the middle of its picture, and
// gives it the focal length (whole px) with which the region fills it but for a margin.
void Aim(const Vector3d& centre, const Vector3d& target, const Vector3d& up,
         const std::vector<Vector3d>& region, Camera* camera) {
  LookAt(centre, target, up, camera);
  constexpr int kTurns = 3;
  for (int i = 0; i < kTurns; ++i) {
    const Vector3d towards = Extent(*camera, region).center().homogeneous();
    LookAt(centre, centre + camera->camera_from_world_rotation.transpose() * towards, up, camera);
  }
  constexpr double kMargin = 0.06;  // of the picture's size, on each side
  const Eigen::AlignedBox2d extent = Extent(*camera, region);
  const Eigen::Array2d reach = extent.max().cwiseAbs().cwiseMax(extent.min().cwiseAbs());
  const Eigen::Array2d half = (0.5 - kMargin) * Eigen::Array2d(camera->width, camera->height);
  camera->fx = camera->fy = std::max(1.0, std::floor((half / reach.max(1e-6)).minCoeff()));
}

}  // namespace

std::vector<Camera> MakeCameraRing(int count, const Vector3d& target, double radius) {
  constexpr double kElevation = 0.3;  // of the radius
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * (static_cast<double>(i) / count - 0.25);
    Camera camera;
    camera.name = "cam" + std::to_string(i);
    camera.width = 640;
    camera.height = 480;
    camera.fx = camera.fy = 720.0;
    camera.cx = 319.5;
    camera.cy = 239.5;
    LookAt(target + radius * Vector3d(std::cos(angle), std::sin(angle), kElevation), target,
           Vector3d::UnitZ(), &camera);
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<Camera> MakeRoomCameras(const RoomCameras& options, const std::vector<Vector3d>& region,
                                    double floor) {
  Vector3d low = region.front(), high = low;
  for (const Vector3d& point : region) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vector3d target = 0.5 * (low + high);
  const int around = std::max(1, options.count - 1);
  std::vector<Camera> cameras;
  for (int i = 0; i < options.count; ++i) {
    Camera camera;
    camera.width = options.size.x();
    camera.height = options.size.y();
    camera.cx = 0.5 * (options.size.x() - 1);
    camera.cy = 0.5 * (options.size.y() - 1);
    camera.distortion = options.distortion;
    if (i < around) {
      // Not quite alike: no camera then sees just what another does from the other side.
      const double angle = 2.0 * M_PI * ((i + 0.3) / around - 0.25);
      const double height = options.height * (1.0 + 0.06 * (i % 3 - 1));
      camera.name = "cam" + std::to_string(i);
      const Vector3d centre(target.x() + options.distance * std::cos(angle),
                            target.y() + options.distance * std::sin(angle), floor + height);
      Aim(centre, target, Vector3d::UnitZ(), region, &camera);
    } else {
      camera.name = "ceiling";
      const Vector3d centre(target.x() + 0.04 * options.ceiling,
                            target.y() - 0.06 * options.ceiling, floor + options.ceiling);
      Aim(centre, target, Vector3d::UnitY(), region, &camera);
    }
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace clothfit
