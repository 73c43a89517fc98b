// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A texture on a plane. Colours are the shares of the light that are reflected, from 0 to 1, in
// OpenCV's order blue, green, red.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// A picture of a rectangle (from (0, 0) to `size`, m), together with smaller copies of it so that
// it can be seen from afar without aliasing (Williams 1983, "Pyramidal Parametrics").
class PlaneTexture {
 public:
  using Colours = std::vector<Eigen::Vector3f>;
  // Beyond the rectangle the picture repeats, or its border goes on.
  enum class Beyond { kRepeat, kBorder };

  // One colour a texel of texel x texel m, rounded so that whole texels fill the rectangle.
  PlaneTexture(const Eigen::Vector2d& size, double texel, Beyond beyond,
               const std::function<Eigen::Vector3f(const Eigen::Vector2d& place)>& colour);

  // Colour about a place (m), averaged over about `footprint` m.
  Eigen::Vector3f At(const Eigen::Vector2d& place, double footprint) const;

 private:
  struct Level {
    Eigen::Vector2i count;  // texels
    Eigen::Vector2d texel;  // m
    Colours colours;        // row by row
  };
  static Level Halved(const Level& fine);
  Eigen::Vector3f Bilinear(const Level& level, const Eigen::Vector2d& place) const;

  Beyond beyond_;
  std::vector<Level> levels_;  // each of half the count of the one before
};

}  // namespace clothfit
