// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Rays in Plücker coordinates: what one pixel says about a point of the cloth.
//
// A ray is a unit direction d and a moment m = q x d, where q is any point on it (Hasler 2007,
// sec. 4; with m = d x q both of the paper's formulas would have the wrong sign). It is treated as
// a line, endless both ways. Everything is templated: T is double or ceres::Jet.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "tracking/camera/camera.h"

namespace clothfit {

template <class T>
struct PluckerRay {
  Eigen::Matrix<T, 3, 1> direction;  // unit length, world
  Eigen::Matrix<T, 3, 1> moment;     // m, world; perpendicular to direction, its length is the
                                     // distance of the ray from the origin
};

// The ray through a point (m, world) along a direction of any length but zero.
template <class T>
PluckerRay<T> RayThrough(const Eigen::Matrix<T, 3, 1>& point,
                         const Eigen::Matrix<T, 3, 1>& direction) {
  using std::sqrt;
  const Eigen::Matrix<T, 3, 1> unit = direction / sqrt(direction.squaredNorm());
  return {unit, point.cross(unit)};
}

// The ray from a camera's centre through a pixel; empty where UndistortPixel is.
inline std::optional<PluckerRay<double>> RayThroughPixel(const Camera& camera,
                                                         const Eigen::Vector2d& pixel) {
  const std::optional<Eigen::Vector3d> direction = PixelDirection(camera, pixel);
  if (!direction) return std::nullopt;
  return RayThrough<double>(CameraCentre(camera), *direction);
}

// The shortest vector (m) from the ray to the point, v = (m - p x d) x d. Hasler 2007, sec. 4.1.
template <class T>
Eigen::Matrix<T, 3, 1> VectorFromRay(const PluckerRay<T>& ray,
                                     const Eigen::Matrix<T, 3, 1>& point) {
  const Eigen::Matrix<T, 3, 1> moment_difference = ray.moment - point.cross(ray.direction);
  return moment_difference.cross(ray.direction);
}

// The same for a measured (constant) ray and a point that is being differentiated.
template <class T>
Eigen::Matrix<T, 3, 1> VectorFromMeasuredRay(const PluckerRay<double>& ray,
                                             const Eigen::Matrix<T, 3, 1>& point) {
  return VectorFromRay<T>({ray.direction.cast<T>(), ray.moment.cast<T>()}, point);
}

// Distance (m) of the point from the ray. Its derivative is set to zero on the ray, where there is
// none.
template <class T>
T DistanceFromRay(const PluckerRay<T>& ray, const Eigen::Matrix<T, 3, 1>& point) {
  using std::sqrt;
  const T squared = VectorFromRay<T>(ray, point).squaredNorm();
  return squared > T(0.0) ? sqrt(squared) : T(0.0);
}

// Squared sine of the angle under which two rays count as parallel (a microradian).
inline constexpr double kParallelSquaredSine = 1e-12;

// The point (m, world) on ray i that is closest to ray j; empty when they are parallel.
// Hasler 2007, sec. 4, c_ij.
template <class T>
std::optional<Eigen::Matrix<T, 3, 1>> ClosestPointOnRay(const PluckerRay<T>& ray_i,
                                                        const PluckerRay<T>& ray_j) {
  const Eigen::Matrix<T, 3, 1>& d_i = ray_i.direction;
  const Eigen::Matrix<T, 3, 1>& d_j = ray_j.direction;
  const Eigen::Matrix<T, 3, 1>& m_i = ray_i.moment;
  const Eigen::Matrix<T, 3, 1>& m_j = ray_j.moment;
  const T squared_sine = d_i.cross(d_j).squaredNorm();
  if (squared_sine < T(kParallelSquaredSine)) return std::nullopt;
  const T along_i =
      (d_i.dot(d_j.cross(m_j)) - d_i.dot(d_j) * d_i.dot(d_j.cross(m_i))) / squared_sine;
  const Eigen::Matrix<T, 3, 1> foot = d_i.cross(m_i);  // closest to the origin
  return Eigen::Matrix<T, 3, 1>(along_i * d_i + foot);
}

}  // namespace clothfit
