// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The empty room is rendered once, with the lamp's light and without. A picture with the cloth
// casts rays only where the cloth or its shadow may be.
#include "tracking/synthetic/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "autodiff_sim/base/parallel.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kShadowMargin = 0.003;  // m, within which a surface does not shade itself
constexpr double kLeastSlant = 0.05;     // cosine; a surface seen edge-on is averaged no further

cv::Vec3f ToPixel(const Vector3f& colour) { return {colour[0], colour[1], colour[2]}; }
Vector3f FromPixel(const cv::Vec3f& colour) { return {colour[0], colour[1], colour[2]}; }

// The smallest rectangle about pixels, with room for what lies between them on a bent line.
class PixelBounds {
 public:
  void Add(const Camera& camera, const Vector3d& point) {
    constexpr double kNear = 0.05;  // m; what comes so near may be anywhere
    if (CameraFromWorld<double>(camera, point).z() < kNear) {
      is_everything_ = true;
      return;
    }
    const Vector2d pixel = ProjectPoint(camera, point);
    low_ = low_.cwiseMin(pixel);
    high_ = high_.cwiseMax(pixel);
  }
  cv::Rect Within(const Camera& camera) const {
    const cv::Rect all(0, 0, camera.width, camera.height);
    if (is_everything_) return all;
    if (!(low_.array() <= high_.array()).all()) return {};
    constexpr double kBorder = 3.0;  // px
    const Eigen::Array2d size(camera.width, camera.height);
    const Eigen::Array2i from = (low_.array() - kBorder).max(-1.0).min(size).floor().cast<int>();
    const Eigen::Array2i to = (high_.array() + kBorder).max(-1.0).min(size).ceil().cast<int>();
    return all & cv::Rect(cv::Point(from.x(), from.y()), cv::Point(to.x() + 1, to.y() + 1));
  }

 private:
  bool is_everything_ = false;
  Vector2d low_ = Vector2d::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
};

}  // namespace

Renderer::Renderer(const Camera& camera, const Room& room, const ClothLook& cloth,
                   const PlaneTexture& floor, int samples, int num_threads)
    : camera_(camera),
      centre_(CameraCentre(camera)),
      room_(room),
      cloth_(cloth),
      floor_(floor),
      samples_(samples),
      directions_(static_cast<std::size_t>(samples) * samples * camera.width * camera.height),
      lit_(camera.height, camera.width, CV_32FC3),
      dark_(camera.height, camera.width, CV_32FC3) {
  ParallelFor(camera.height, num_threads, [this](int y, int) {
    FindDirections(y);
    RenderEmpty(y);
  });
}

// Where a strong lens shows nothing that is, the picture shows what the pinhole would.
Vector3d Renderer::Direction(const Vector2d& pixel) const {
  if (const auto direction = PixelDirection(camera_, pixel)) return *direction;
  Camera pinhole = camera_;
  pinhole.distortion = {};
  return *PixelDirection(pinhole, pixel);
}

std::size_t Renderer::SampleIndex(int x, int y, int sample) const {
  return static_cast<std::size_t>((y * camera_.width + x) * samples_ * samples_ + sample);
}

void Renderer::FindDirections(int y) {
  for (int x = 0; x < camera_.width; ++x) {
    for (int s = 0; s < samples_ * samples_; ++s) {
      const Vector2d in_pixel((s % samples_ + 0.5) / samples_ - 0.5,
                              (s / samples_ + 0.5) / samples_ - 0.5);
      directions_[SampleIndex(x, y, s)] = Direction(Vector2d(x, y) + in_pixel);
    }
  }
}

void Renderer::RenderEmpty(int y) {
  const int count = samples_ * samples_;
  for (int x = 0; x < camera_.width; ++x) {
    Vector3f lit = Vector3f::Zero(), dark = Vector3f::Zero();
    for (int s = 0; s < count; ++s) {
      const Vector3d& direction = directions_[SampleIndex(x, y, s)];
      const RoomPoint point = HitRoom(room_, centre_, direction);
      const double slant = std::max(kLeastSlant, -point.normal.dot(direction));
      const Vector3f colour = RoomColour(room_, floor_, point, Footprint(point.distance, slant));
      lit += static_cast<float>(Irradiance(room_, point.position, point.normal, true)) * colour;
      dark += static_cast<float>(Irradiance(room_, point.position, point.normal, false)) * colour;
    }
    lit_.at<cv::Vec3f>(y, x) = ToPixel(lit / static_cast<float>(count));
    dark_.at<cv::Vec3f>(y, x) = ToPixel(dark / static_cast<float>(count));
  }
}

double Renderer::Footprint(double distance, double slant) const {
  return distance / (camera_.fx * samples_ * std::sqrt(slant));
}

Vector3f Renderer::ShadeCloth(const ClothSurface& cloth, const SeenPoint& seen) const {
  const Vector3d to_eye = (centre_ - seen.position).normalized();
  const double slant = std::max(kLeastSlant, seen.facet.dot(to_eye));
  const Vector3f colour = cloth_.texture.At(seen.uv, Footprint(seen.distance, slant));
  const Vector3d to_lamp = (room_.lamp - seen.position).normalized();
  const double cosine = seen.normal.dot(to_lamp);
  const bool is_lit = cosine > 0.0 && seen.facet.dot(to_lamp) > 0.0 &&
                      !cloth.rays().IsBlocked(room_.lamp, seen.position, kShadowMargin);
  const Vector3f diffuse =
      static_cast<float>(Irradiance(room_, seen.position, seen.normal, is_lit)) * colour;
  if (!is_lit || cloth_.specular <= 0.0) return diffuse;
  const double half = std::max(0.0, seen.normal.dot((to_lamp + to_eye).normalized()));
  const double highlight = cloth_.specular * room_.lamp_strength * std::pow(half, cloth_.shininess);
  return diffuse + Vector3f::Constant(static_cast<float>(highlight));
}

bool Renderer::IsInShadow(const ClothSurface& cloth, const Vector3d& direction) const {
  return cloth.rays().IsBlocked(room_.lamp, HitRoom(room_, centre_, direction).position, 0.0);
}

Vector3f Renderer::Sample(const ClothSurface& cloth, int x, int y, int sample,
                          bool may_be_cloth) const {
  const Vector3d& direction =
      directions_[static_cast<std::size_t>((y * camera_.width + x) * samples_ * samples_ + sample)];
  if (may_be_cloth) {
    if (const auto seen = cloth.First(centre_, direction)) return ShadeCloth(cloth, *seen);
  }
  return FromPixel((IsInShadow(cloth, direction) ? dark_ : lit_).at<cv::Vec3f>(y, x));
}

cv::Rect Renderer::ClothRegion(const ClothSurface& cloth) const {
  PixelBounds bounds;
  for (Eigen::Index i = 0; i < cloth.positions().size(); i += 3)
    bounds.Add(camera_, cloth.positions().segment<3>(i));
  return bounds.Within(camera_);
}

cv::Rect Renderer::ShadowRegion(const ClothSurface& cloth) const {
  PixelBounds bounds;
  for (Eigen::Index i = 0; i < cloth.positions().size(); i += 3) {
    const Vector3d from_lamp = cloth.positions().segment<3>(i) - room_.lamp;
    bounds.Add(camera_, HitRoom(room_, room_.lamp, from_lamp).position);
  }
  return bounds.Within(camera_);
}

cv::Mat Renderer::Render(const ClothSurface& cloth) const {
  cv::Mat picture = lit_.clone();
  const cv::Rect on_cloth = ClothRegion(cloth), in_shadow = ShadowRegion(cloth);
  const cv::Rect either = on_cloth | in_shadow;
  const int count = samples_ * samples_;
  for (int y = either.y; y < either.y + either.height; ++y) {
    for (int x = either.x; x < either.x + either.width; ++x) {
      const bool may_be_cloth = on_cloth.contains({x, y});
      if (!may_be_cloth && !in_shadow.contains({x, y})) continue;
      Vector3f sum = Vector3f::Zero();
      for (int s = 0; s < count; ++s) sum += Sample(cloth, x, y, s, may_be_cloth);
      picture.at<cv::Vec3f>(y, x) = ToPixel(sum / static_cast<float>(count));
    }
  }
  return picture;
}

cv::Mat Renderer::Mask(const ClothSurface& cloth) const {
  cv::Mat mask = cv::Mat::zeros(camera_.height, camera_.width, CV_8UC1);
  const cv::Rect region = ClothRegion(cloth);
  for (int y = region.y; y < region.y + region.height; ++y) {
    for (int x = region.x; x < region.x + region.width; ++x) {
      if (cloth.rays().First(centre_, Direction(Vector2d(x, y)))) mask.at<uchar>(y, x) = 255;
    }
  }
  return mask;
}

}  // namespace clothfit
