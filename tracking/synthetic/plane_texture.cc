// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/plane_texture.h"

#include <algorithm>
#include <cmath>

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3f;

int Inside(int index, int count, PlaneTexture::Beyond beyond) {
  if (beyond == PlaneTexture::Beyond::kBorder) return std::clamp(index, 0, count - 1);
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

// A fine texel, and which share of a coarse one it makes up.
struct Part {
  int index;
  float share;
};

// Those of the coarse texel that is `ratio` fine ones wide, along one axis.
std::vector<Part> Parts(int coarse, double ratio, int fine_count) {
  const double from = coarse * ratio, to = from + ratio;
  std::vector<Part> parts;
  for (int i = static_cast<int>(from); i < fine_count && i < to; ++i) {
    const double overlap = std::min(to, i + 1.0) - std::max(from, static_cast<double>(i));
    parts.push_back({i, static_cast<float>(overlap / ratio)});
  }
  return parts;
}

}  // namespace

PlaneTexture::PlaneTexture(const Vector2d& size, double texel, Beyond beyond,
                           const std::function<Vector3f(const Vector2d&)>& colour)
    : beyond_(beyond) {
  Level first;
  first.count = (size / texel).array().round().cast<int>().max(1);
  first.texel = (size.array() / first.count.cast<double>().array()).matrix();
  first.colours.reserve(static_cast<std::size_t>(first.count.prod()));
  constexpr double kSamples[] = {0.25, 0.75};  // of a texel
  for (int j = 0; j < first.count.y(); ++j) {
    for (int i = 0; i < first.count.x(); ++i) {
      Vector3f sum = Vector3f::Zero();
      for (const double y : kSamples) {
        for (const double x : kSamples)
          sum += colour(Vector2d((i + x) * first.texel.x(), (j + y) * first.texel.y()));
      }
      first.colours.push_back(0.25F * sum);
    }
  }
  levels_.push_back(std::move(first));
  while (levels_.back().count.maxCoeff() > 1) levels_.push_back(Halved(levels_.back()));
}

PlaneTexture::Level PlaneTexture::Halved(const Level& fine) {
  Level coarse;
  coarse.count = ((fine.count.array() + 1) / 2).matrix();
  // Of an odd count the coarse texels are not quite twice as wide, and cover parts of fine ones.
  const Eigen::Array2d ratio =
      fine.count.cast<double>().array() / coarse.count.cast<double>().array();
  coarse.texel = (fine.texel.array() * ratio).matrix();
  for (int j = 0; j < coarse.count.y(); ++j) {
    const std::vector<Part> rows = Parts(j, ratio.y(), fine.count.y());
    for (int i = 0; i < coarse.count.x(); ++i) {
      Vector3f sum = Vector3f::Zero();
      for (const Part& column : Parts(i, ratio.x(), fine.count.x())) {
        for (const Part& row : rows) {
          sum += row.share * column.share *
                 fine.colours[static_cast<std::size_t>(row.index * fine.count.x() + column.index)];
        }
      }
      coarse.colours.push_back(sum);
    }
  }
  return coarse;
}

Vector3f PlaneTexture::Bilinear(const Level& level, const Vector2d& place) const {
  const double x = place.x() / level.texel.x() - 0.5, y = place.y() / level.texel.y() - 0.5;
  const double x0 = std::floor(x), y0 = std::floor(y);
  const float s = static_cast<float>(x - x0), t = static_cast<float>(y - y0);
  const int i0 = Inside(static_cast<int>(x0), level.count.x(), beyond_);
  const int i1 = Inside(static_cast<int>(x0) + 1, level.count.x(), beyond_);
  const int j0 = Inside(static_cast<int>(y0), level.count.y(), beyond_) * level.count.x();
  const int j1 = Inside(static_cast<int>(y0) + 1, level.count.y(), beyond_) * level.count.x();
  const auto at = [&level](int index) -> const Vector3f& {
    return level.colours[static_cast<std::size_t>(index)];
  };
  return (1.0F - t) * ((1.0F - s) * at(j0 + i0) + s * at(j0 + i1)) +
         t * ((1.0F - s) * at(j1 + i0) + s * at(j1 + i1));
}

Vector3f PlaneTexture::At(const Vector2d& place, double footprint) const {
  const double texel = levels_.front().texel.maxCoeff();
  const double level = std::clamp(std::log2(std::max(footprint, 1e-9) / texel), 0.0,
                                  static_cast<double>(levels_.size() - 1));
  const std::size_t fine = static_cast<std::size_t>(level);
  const Vector3f colour = Bilinear(levels_[fine], place);
  const float rest = static_cast<float>(level - static_cast<double>(fine));
  if (rest <= 0.0F) return colour;
  return (1.0F - rest) * colour + rest * Bilinear(levels_[fine + 1], place);
}

}  // namespace clothfit
