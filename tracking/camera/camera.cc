// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/camera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <ceres/jet.h>

namespace clothfit {
namespace {

// The lens at one point: where it maps it to, and the Jacobian of that.
struct Lens {
  Eigen::Vector2d distorted;
  Eigen::Matrix2d jacobian;
};

Lens EvaluateLens(const Camera& camera, const Eigen::Vector2d& normalised) {
  using Jet = ceres::Jet<double, 2>;
  const Eigen::Matrix<Jet, 2, 1> point(Jet(normalised.x(), 0), Jet(normalised.y(), 1));
  const Eigen::Matrix<Jet, 2, 1> distorted = Distort<Jet>(camera.distortion, point);
  Lens lens;
  lens.distorted = {distorted.x().a, distorted.y().a};
  lens.jacobian << distorted.x().v.transpose(), distorted.y().v.transpose();
  return lens;
}

}  // namespace

bool IsInFront(const Camera& camera, const Eigen::Vector3d& point_in_world) {
  return CameraFromWorld<double>(camera, point_in_world).z() > 0.0;
}

bool IsInImage(const Camera& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() >= -0.5 && pixel.x() < camera.width - 0.5 && pixel.y() >= -0.5 &&
         pixel.y() < camera.height - 0.5;
}

Eigen::Vector3d CameraCentre(const Camera& camera) {
  // The inverse, not the transpose: a rotation read from decimals is only nearly orthogonal.
  return -(camera.camera_from_world_rotation.inverse() * camera.camera_from_world_translation);
}

std::optional<Eigen::Vector2d> UndistortPixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d target((pixel.x() - camera.cx) / camera.fx,
                               (pixel.y() - camera.cy) / camera.fy);
  constexpr int kMaxIterations = 100;
  constexpr double kTolerance = 1e-14;
  // Newton's method from the undistorted guess. A step that makes things worse is halved; one that
  // crosses to where the lens folds the picture over (determinant <= 0) is none.
  Eigen::Vector2d point = target;
  Lens lens = EvaluateLens(camera, point);
  if (lens.jacobian.determinant() <= 0.0) {  // beyond the fold: come from the axis instead
    point.setZero();
    lens = EvaluateLens(camera, point);
  }
  double error = (lens.distorted - target).norm();
  const double tolerance = kTolerance * (1.0 + target.norm());
  for (int i = 0; i < kMaxIterations && error > tolerance; ++i) {
    Eigen::Vector2d step = lens.jacobian.inverse() * (target - lens.distorted);
    bool improved = false;
    for (int halving = 0; halving < 30 && !improved; ++halving, step *= 0.5) {
      const Lens next = EvaluateLens(camera, point + step);
      const double next_error = (next.distorted - target).norm();
      if (next.jacobian.determinant() <= 0.0 || !(next_error < error)) continue;
      point += step;
      lens = next;
      error = next_error;
      improved = true;
    }
    if (!improved) break;
  }
  constexpr double kAccepted = 1e-12;  // where rounding stopped the iteration short of kTolerance
  if (!(error <= kAccepted * (1.0 + target.norm()))) return std::nullopt;
  return point;
}

std::optional<Eigen::Vector3d> PixelDirection(const Camera& camera, const Eigen::Vector2d& pixel) {
  const std::optional<Eigen::Vector2d> normalised = UndistortPixel(camera, pixel);
  if (!normalised) return std::nullopt;
  const Eigen::Vector3d direction =
      camera.camera_from_world_rotation.inverse() * normalised->homogeneous();
  return direction.normalized();
}

}  // namespace clothfit
