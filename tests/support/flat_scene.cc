// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flat_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace clothfit {
namespace {

constexpr double kClothTexel = 0.002, kFloorTexel = 0.005;  // m
constexpr double kFloorHalf = 4.0;                          // m

// Smooth noise on several scales, coloured.
cv::Mat Texture(int width, int height, const cv::Scalar& mean, double contrast, int seed) {
  cv::RNG random(static_cast<std::uint64_t>(seed));
  cv::Mat sum(height, width, CV_32FC3, mean);
  for (const double blur : {2.0, 5.0, 12.0}) {
    cv::Mat noise(height, width, CV_32FC3);
    random.fill(noise, cv::RNG::NORMAL, 0.0, contrast * 2.0 * blur);
    cv::GaussianBlur(noise, noise, {}, blur);
    sum += noise;
  }
  cv::Mat texture;
  sum.convertTo(texture, CV_8U);
  return texture;
}

cv::Vec3f Sample(const cv::Mat& texture, double x, double y) {
  const int x0 = std::clamp(static_cast<int>(std::floor(x)), 0, texture.cols - 2);
  const int y0 = std::clamp(static_cast<int>(std::floor(y)), 0, texture.rows - 2);
  const float fx = static_cast<float>(std::clamp(x - x0, 0.0, 1.0));
  const float fy = static_cast<float>(std::clamp(y - y0, 0.0, 1.0));
  const auto at = [&](int i, int j) { return cv::Vec3f(texture.at<cv::Vec3b>(y0 + j, x0 + i)); };
  return (at(0, 0) * (1 - fx) + at(1, 0) * fx) * (1 - fy) +
         (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy;
}

// Where a ray meets the plane through the cloth, in its (u, v).
Eigen::Vector2d Meet(const FlatPlacement& plane, const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& direction) {
  const Eigen::Vector3d normal = plane.u_axis.cross(plane.v_axis);
  const double along = normal.dot(plane.origin - origin) / normal.dot(direction);
  const Eigen::Vector3d d = origin + along * direction - plane.origin;
  return {d.dot(plane.u_axis), d.dot(plane.v_axis)};
}

bool IsOnCloth(const Eigen::Vector2d& uv, const Eigen::Vector2d& size) {
  return uv.x() >= 0.0 && uv.y() >= 0.0 && uv.x() <= size.x() && uv.y() <= size.y();
}

}  // namespace

FlatScene::FlatScene(const Eigen::Vector2d& size)
    : size_(size),
      cloth_(Texture(static_cast<int>(size.x() / kClothTexel) + 2,
                     static_cast<int>(size.y() / kClothTexel) + 2, {60, 90, 190}, 40.0, 7)),
      floor_(Texture(static_cast<int>(2.0 * kFloorHalf / kFloorTexel),
                     static_cast<int>(2.0 * kFloorHalf / kFloorTexel), {120, 130, 125}, 12.0, 9)) {}

cv::Mat FlatScene::Render(const Camera& camera, const FlatPlacement& cloth,
                          const Lighting& lighting) const {
  cv::Mat sum(camera.height, camera.width, CV_32FC3, cv::Scalar::all(0.0));
  const Eigen::Vector3d centre = CameraCentre(camera);
  const FlatPlacement floor = Placement({0.0, 0.0, -0.01});
  constexpr int kSamples = 3;  // a pixel, each way
  for (int y = 0; y < kSamples * camera.height; ++y) {
    for (int x = 0; x < kSamples * camera.width; ++x) {
      const Eigen::Vector2d pixel((x + 0.5) / kSamples - 0.5, (y + 0.5) / kSamples - 0.5);
      const Eigen::Vector3d direction = *PixelDirection(camera, pixel);
      const Eigen::Vector2d uv = Meet(cloth, centre, direction);
      cv::Vec3f colour;
      if (IsOnCloth(uv, size_)) {
        colour = Sample(cloth_, uv.x() / kClothTexel, uv.y() / kClothTexel);
      } else {
        const Eigen::Vector2d on_floor = Meet(floor, centre, direction);
        colour = Sample(floor_, (on_floor.x() + kFloorHalf) / kFloorTexel,
                        (on_floor.y() + kFloorHalf) / kFloorTexel);
        const bool is_dark = IsOnCloth(uv - Eigen::Vector2d(0.08, 0.0), size_);
        if (is_dark) colour *= static_cast<float>(lighting.shadow);
      }
      sum.at<cv::Vec3f>(y / kSamples, x / kSamples) += colour;
    }
  }
  sum *= lighting.gain / (kSamples * kSamples);
  cv::Mat noise(sum.size(), CV_32FC3), image;
  cv::RNG random(lighting.seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, std::max(1e-9, lighting.noise));
  cv::Mat(sum + noise).convertTo(image, CV_8U);
  return image;
}

cv::Mat FlatScene::RenderEmpty(const Camera& camera, const Lighting& lighting) const {
  return Render(camera, Placement({100.0, 0.0, 0.0}), lighting);
}

cv::Mat FlatScene::Mask(const Camera& camera, const FlatPlacement& cloth) const {
  cv::Mat mask(camera.height, camera.width, CV_8U);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d uv = Meet(cloth, CameraCentre(camera), *PixelDirection(camera, {x, y}));
      mask.at<uchar>(y, x) = IsOnCloth(uv, size_) ? 255 : 0;
    }
  }
  return mask;
}

FlatPlacement FlatScene::Placement(const Eigen::Vector3d& origin, double turned) {
  return {origin,
          {std::cos(turned), std::sin(turned), 0.0},
          {-std::sin(turned), std::cos(turned), 0.0}};
}

PlacedCloth FlatScene::Place(const FlatPlacement& cloth) const {
  Recording recording;
  recording.cloth.size = size_;
  recording.cloth.resolution = {9, 7};
  recording.cloth.initial = cloth;
  return PlaceCloth(recording);
}

Eigen::Vector2d FlatScene::Project(const Camera& camera, const FlatPlacement& cloth,
                                   const Eigen::Vector2d& uv) const {
  return ProjectPoint(camera, cloth.origin + uv.x() * cloth.u_axis + uv.y() * cloth.v_axis);
}

Camera LookAt(const Eigen::Vector3d& centre, const Eigen::Vector3d& target, double focal) {
  Camera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = focal;
  camera.cx = 159.5;
  camera.cy = 119.5;
  const Eigen::Vector3d z = (target - centre).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d(0.0, 1.0, 0.1)).normalized();
  camera.camera_from_world_rotation.row(0) = x.transpose();
  camera.camera_from_world_rotation.row(1) = z.cross(x).transpose();
  camera.camera_from_world_rotation.row(2) = z.transpose();
  camera.camera_from_world_translation = -camera.camera_from_world_rotation * centre;
  return camera;
}

}  // namespace clothfit
