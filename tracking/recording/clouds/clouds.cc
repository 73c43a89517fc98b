// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/clouds/clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/recording/clouds/file.h"
#include "tracking/recording/limits.h"
#include "tracking/recording/pictures/images.h"

namespace clothfit {
namespace {

using Cell = std::array<std::int64_t, 3>;

// The points' cells, each with the point's place in the order; sorted.
std::vector<std::pair<Cell, std::size_t>> SortedCells(const std::vector<Eigen::Vector3d>& points,
                                                      double edge) {
  std::vector<std::pair<Cell, std::size_t>> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d cell = (points[i] / edge).array().floor();
    cells.push_back({{std::int64_t(cell.x()), std::int64_t(cell.y()), std::int64_t(cell.z())}, i});
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace

std::vector<Eigen::Vector3d> LoadCloud(const Recording& recording, int frame) {
  const auto found = recording.clouds.files.find(frame);
  if (found == recording.clouds.files.end()) return {};
  std::vector<Eigen::Vector3d> points = ReadCloudFile(found->second);
  for (const Eigen::Vector3d& point : points) {
    if (point.cwiseAbs().maxCoeff() <= kFarthest) continue;
    throw InputError(found->second.string(),
                     fmt::format("has a point at ({:g}, {:g}, {:g}); expected metres, at most {:g} "
                                 "from the origin",
                                 point.x(), point.y(), point.z(), kFarthest));
  }
  return points;
}

std::vector<Eigen::Vector3d> LoadDepth(const Recording& recording, int camera, int frame) {
  const cv::Mat depth = LoadDepthPicture(recording, camera, frame);
  if (depth.empty()) return {};
  const cv::Mat mask = LoadMask(recording, camera, frame);
  const Camera& of = recording.cameras[static_cast<std::size_t>(camera)];
  const double scale = recording.clouds.depth_scales.at(of.name);
  std::vector<Eigen::Vector3d> points;
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double along = scale * depth.at<std::uint16_t>(y, x);
      if (along == 0.0 || (!mask.empty() && mask.at<std::uint8_t>(y, x) == 0)) continue;
      const std::optional<Eigen::Vector2d> normalised = UndistortPixel(of, Eigen::Vector2d(x, y));
      if (!normalised) continue;
      const Eigen::Vector3d in_camera = along * normalised->homogeneous();
      points.emplace_back(of.camera_from_world_rotation.transpose() *
                          (in_camera - of.camera_from_world_translation));
    }
  }
  return points;
}

ThinnedPoints ThinPoints(const std::vector<Eigen::Vector3d>& points, double spacing, int most) {
  ThinnedPoints thinned;
  thinned.spacing = spacing;
  for (;;) {
    thinned.points.clear();
    const auto cells = SortedCells(points, thinned.spacing);
    for (auto first = cells.begin(); first != cells.end();) {
      const auto last = std::find_if(
          first, cells.end(), [&](const auto& other) { return other.first != first->first; });
      thinned.points.push_back(points[(first + (last - first) / 2)->second]);
      first = last;
    }
    const auto count = static_cast<double>(thinned.points.size());
    if (count <= most) return thinned;
    // Of a surface there are as many as its area takes.
    thinned.spacing *= std::max(1.02, std::sqrt(count / most));
  }
}

}  // namespace clothfit
