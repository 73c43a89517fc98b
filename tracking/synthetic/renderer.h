// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a cloth in a room, by casting rays: what a camera without noise would measure.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "tracking/camera/camera.h"
#include "tracking/recording/surface/cloth_surface.h"
#include "tracking/synthetic/procedural_texture.h"
#include "tracking/synthetic/room.h"

namespace clothfit {

// How a cloth reflects: as Lambert's law says on both sides, and where `specular` is above 0 by a
// highlight of the lamp's own colour too (Blinn 1977).
struct ClothLook {
  PlaneTexture texture;
  double specular = 0.0;    // share of the lamp's light in the middle of the highlight
  double shininess = 30.0;  // exponent
};

// One camera's view of the room. Everything is fixed but the cloth; calls of const functions may
// run at the same time, each with a surface of its own.
class Renderer {
 public:
  // Each pixel is the mean of samples x samples rays. The empty room is rendered at once, by
  // num_threads. The room, the look and the floor's texture
  // must outlive it.
  Renderer(const Camera& camera, const Room& room, const ClothLook& cloth,
           const PlaneTexture& floor, int samples, int num_threads = 1);

  // CV_32FC3, blue, green, red; see Room about the unit. The room without the cloth.
  const cv::Mat& empty() const { return lit_; }
  // The room with the cloth and its shadows, likewise.
  cv::Mat Render(const ClothSurface& cloth) const;
  // CV_8UC1: 255 where the ray through the pixel's centre meets the cloth, else 0.
  cv::Mat Mask(const ClothSurface& cloth) const;

 private:
  // m, the width of what a sample sees of a surface, whose cosine to the ray is `slant`.
  double Footprint(double distance, double slant) const;
  std::size_t SampleIndex(int x, int y, int sample) const;
  Eigen::Vector3d Direction(const Eigen::Vector2d& pixel) const;
  void FindDirections(int y);
  void RenderEmpty(int y);
  Eigen::Vector3f ShadeCloth(const ClothSurface& cloth, const SeenPoint& seen) const;
  bool IsInShadow(const ClothSurface& cloth, const Eigen::Vector3d& direction) const;
  Eigen::Vector3f Sample(const ClothSurface& cloth, int x, int y, int sample,
                         bool may_be_cloth) const;
  cv::Rect ClothRegion(const ClothSurface& cloth) const;
  cv::Rect ShadowRegion(const ClothSurface& cloth) const;

  Camera camera_;
  Eigen::Vector3d centre_;  // m, world, of the camera
  const Room& room_;
  const ClothLook& cloth_;
  const PlaneTexture& floor_;
  int samples_;
  std::vector<Eigen::Vector3d> directions_;  // of the samples, pixel by pixel
  cv::Mat lit_, dark_;                       // the empty room with and without the lamp's light
};

}  // namespace clothfit
