// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace clothfit {

SilhouetteRaster::SilhouetteRaster(const Camera& camera, std::vector<std::array<int, 3>> triangles)
    : camera_(camera),
      triangles_(std::move(triangles)),
      is_distorted_(std::any_of(camera.distortion.begin(), camera.distortion.end(),
                                [](double k) { return k != 0.0; })) {
  if (!is_distorted_) return;
  normalised_.reserve(static_cast<std::size_t>(camera.width) * camera.height);
  const double nan = std::numeric_limits<double>::quiet_NaN();  // covered by nothing
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      normalised_.push_back(
          UndistortPixel(camera, Eigen::Vector2d(x, y)).value_or(Eigen::Vector2d::Constant(nan)));
    }
  }
}

Eigen::Vector2d SilhouetteRaster::Normalised(int x, int y) const {
  if (is_distorted_) return normalised_[static_cast<std::size_t>(y) * camera_.width + x];
  return {(x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy};
}

SilhouetteRaster::Triangle SilhouetteRaster::Prepare(const std::array<int, 3>& nodes,
                                                     const Eigen::Matrix3Xd& in_camera) const {
  Triangle triangle;
  for (int k = 0; k < 3; ++k) {
    const int a = nodes[k], b = nodes[(k + 1) % 3];
    triangle.normals[k] = in_camera.col(std::min(a, b)).cross(in_camera.col(std::max(a, b)));
    triangle.signs[k] = a < b ? 1.0 : -1.0;
  }
  triangle.volume = triangle.signs[0] * triangle.normals[0].dot(in_camera.col(nodes[2]));
  if (triangle.volume < 0.0) {
    for (double& sign : triangle.signs) sign = -sign;
  }
  return triangle;
}

// A ray d, z = 1, meets the plane of the triangle in front of the camera where the sum of the
// signed products is positive; so all of them must be at least 0.
bool SilhouetteRaster::Covers(const Triangle& triangle, const Eigen::Vector2d& normalised) const {
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& n = triangle.normals[k];
    const double side = n.x() * normalised.x() + (n.y() * normalised.y() + n.z());
    if (!(triangle.signs[k] * side >= 0.0)) return false;
  }
  return true;
}

bool SilhouetteRaster::FindBox(const std::array<int, 3>& nodes, const Eigen::Matrix3Xd& in_camera,
                               Box* box) const {
  *box = {0, camera_.width - 1, 0, camera_.height - 1};
  constexpr double kNear = 1e-9;  // m
  int in_front = 0;
  for (const int node : nodes) in_front += in_camera(2, node) > kNear ? 1 : 0;
  if (in_front == 0) return false;
  if (in_front < 3) return true;  // reaches to infinity in the picture: anywhere
  Eigen::Array2d lowest = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d highest = -lowest;
  // A lens bends the sides.
  const int parts = is_distorted_ ? 8 : 1;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d a = in_camera.col(nodes[k]), b = in_camera.col(nodes[(k + 1) % 3]);
    for (int i = 0; i < parts; ++i) {
      const Eigen::Vector3d point = a + (static_cast<double>(i) / parts) * (b - a);
      const Eigen::Array2d pixel = ProjectCameraPoint<double>(camera_, point).array();
      lowest = lowest.min(pixel);
      highest = highest.max(pixel);
    }
  }
  const double margin = is_distorted_ ? 2.0 + 0.05 * (highest - lowest).maxCoeff() : 1.0;
  const auto clamp = [](double value, int most) {
    return static_cast<int>(std::clamp(value, -1.0, most + 1.0));
  };
  box->left = std::max(0, clamp(std::floor(lowest.x() - margin), camera_.width));
  box->right = std::min(camera_.width - 1, clamp(std::ceil(highest.x() + margin), camera_.width));
  box->top = std::max(0, clamp(std::floor(lowest.y() - margin), camera_.height));
  box->bottom =
      std::min(camera_.height - 1, clamp(std::ceil(highest.y() + margin), camera_.height));
  return box->left <= box->right && box->top <= box->bottom;
}

// Without distortion the pixels of a row that a triangle covers are a span: its ends are found from
// the sides, roughly, and then by the rule itself.
void SilhouetteRaster::DrawRow(const Triangle& triangle, int y, int left, int right,
                               BitMask* mask) const {
  const double row = (y - camera_.cy) / camera_.fy;
  double first = left, last = right;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& n = triangle.normals[k];
    const double slope = triangle.signs[k] * n.x();
    const double offset = triangle.signs[k] * (n.y() * row + n.z());
    if (slope == 0.0) {
      if (offset < 0.0) return;
      continue;
    }
    const double crossing = camera_.cx - camera_.fx * offset / slope;
    if ((slope > 0.0) == (camera_.fx > 0.0)) {
      first = std::max(first, crossing);
    } else {
      last = std::min(last, crossing);
    }
  }
  if (!(last - first > -1.0)) return;
  int begin = std::max(left, static_cast<int>(std::floor(first)) - 1);
  int end = std::min(right, static_cast<int>(std::ceil(last)) + 1);
  while (begin <= end && !Covers(triangle, Normalised(begin, y))) ++begin;
  while (end >= begin && !Covers(triangle, Normalised(end, y))) --end;
  if (begin <= end) mask->SetSpan(y, begin, end);
}

void SilhouetteRaster::Draw(const Eigen::VectorXd& x, BitMask* mask) const {
  if (mask->width() == camera_.width && mask->height() == camera_.height) {
    mask->Clear();
  } else {
    *mask = BitMask(camera_.width, camera_.height);
  }
  const Eigen::Map<const Eigen::Matrix3Xd> world(x.data(), 3, x.size() / 3);
  const Eigen::Matrix3Xd in_camera = (camera_.camera_from_world_rotation * world).colwise() +
                                     camera_.camera_from_world_translation;
  Box box{};
  for (const std::array<int, 3>& nodes : triangles_) {
    if (!FindBox(nodes, in_camera, &box)) continue;
    const Triangle triangle = Prepare(nodes, in_camera);
    // Seen edge-on, or not a number.
    if (!(std::abs(triangle.volume) > 0.0)) continue;
    for (int y = box.top; y <= box.bottom; ++y) {
      if (!is_distorted_) {
        DrawRow(triangle, y, box.left, box.right, mask);
        continue;
      }
      for (int column = box.left; column <= box.right; ++column) {
        if (Covers(triangle, Normalised(column, y))) mask->SetSpan(y, column, column);
      }
    }
  }
}

}  // namespace clothfit
