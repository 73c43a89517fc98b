// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A pinhole camera with OpenCV's lens distortion (k1, k2, p1, p2, k3).
//
// Pixels: x right, y down, the centre of the top-left pixel is (0, 0). The camera looks along its
// own +z. Normalised coordinates are (x / z, y / z) in the camera's frame.
// Reference: OpenCV 4.6, calib3d, "Camera Calibration and 3D Reconstruction", detailed description.
#pragma once

#include <array>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace clothfit {

struct Camera {
  std::string name;
  int width = 0;                       // px
  int height = 0;                      // px
  double fx = 1.0, fy = 1.0;           // px, focal lengths
  double cx = 0.0, cy = 0.0;           // px, principal point
  std::array<double, 5> distortion{};  // k1, k2, p1, p2, k3; all zero: none
  // x_camera = rotation x_world + translation (m)
  Eigen::Matrix3d camera_from_world_rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d camera_from_world_translation = Eigen::Vector3d::Zero();
};

template <class T>
Eigen::Matrix<T, 3, 1> CameraFromWorld(const Camera& camera,
                                       const Eigen::Matrix<T, 3, 1>& point_in_world) {
  return camera.camera_from_world_rotation.cast<T>() * point_in_world +
         camera.camera_from_world_translation.cast<T>();
}

// Applies the lens to normalised coordinates.
template <class T>
Eigen::Matrix<T, 2, 1> Distort(const std::array<double, 5>& distortion,
                               const Eigen::Matrix<T, 2, 1>& normalised) {
  const auto& [k1, k2, p1, p2, k3] = distortion;
  const T& x = normalised.x();
  const T& y = normalised.y();
  const T r2 = x * x + y * y;
  const T radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

// Pixel of a point given in the camera's own frame (m). For a moving or doubtful pose.
template <class T>
Eigen::Matrix<T, 2, 1> ProjectCameraPoint(const Camera& camera,
                                          const Eigen::Matrix<T, 3, 1>& point_in_camera) {
  const Eigen::Matrix<T, 2, 1> normalised(point_in_camera.x() / point_in_camera.z(),
                                          point_in_camera.y() / point_in_camera.z());
  const Eigen::Matrix<T, 2, 1> distorted = Distort<T>(camera.distortion, normalised);
  return {camera.fx * distorted.x() + camera.cx, camera.fy * distorted.y() + camera.cy};
}

// Pixel of a point in the world (m). Means nothing unless IsInFront: check that first, on plain
// values. T is double or ceres::Jet.
template <class T>
Eigen::Matrix<T, 2, 1> ProjectPoint(const Camera& camera,
                                    const Eigen::Matrix<T, 3, 1>& point_in_world) {
  return ProjectCameraPoint<T>(camera, CameraFromWorld<T>(camera, point_in_world));
}

inline Eigen::Vector2d ProjectPoint(const Camera& camera, const Eigen::Vector3d& point_in_world) {
  return ProjectPoint<double>(camera, point_in_world);
}

// True when the point lies strictly before the plane through the camera's centre.
bool IsInFront(const Camera& camera, const Eigen::Vector3d& point_in_world);

// True when the pixel lies on the picture: -0.5 <= x < width - 0.5, and likewise y.
bool IsInImage(const Camera& camera, const Eigen::Vector2d& pixel);

// The camera's centre (m, world).
Eigen::Vector3d CameraCentre(const Camera& camera);

// Normalised coordinates that the lens maps onto this pixel, to 1e-12 or better. Empty where the
// distortion has no inverse on the side of the axis (far outside the picture of a strong lens).
std::optional<Eigen::Vector2d> UndistortPixel(const Camera& camera, const Eigen::Vector2d& pixel);

// Unit direction (world) from the camera's centre through the pixel; empty as UndistortPixel is.
std::optional<Eigen::Vector3d> PixelDirection(const Camera& camera, const Eigen::Vector2d& pixel);

}  // namespace clothfit
