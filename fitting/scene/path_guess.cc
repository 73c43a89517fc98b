// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/path_guess.h"

#include <optional>
#include <stdexcept>

#include "tracking/recording/surface/thin_plate_spline.h"

namespace clothfit {
namespace {

std::optional<Eigen::Vector3d> SurfaceAt(const std::vector<Eigen::Vector2d>& sites,
                                         const std::vector<Eigen::Vector3d>& values,
                                         const Eigen::Vector2d& uv) {
  constexpr std::size_t kFewestMarkers = 4;
  if (sites.size() < kFewestMarkers) return std::nullopt;
  Eigen::Matrix2Xd site_columns(2, sites.size());
  Eigen::Matrix3Xd value_columns(3, values.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    site_columns.col(static_cast<Eigen::Index>(i)) = sites[i];
    value_columns.col(static_cast<Eigen::Index>(i)) = values[i];
  }
  try {
    return ThinPlateSpline(site_columns, value_columns)(uv);
  } catch (const std::invalid_argument&) {  // on one line, or two at one place
    return std::nullopt;
  }
}

}  // namespace

std::vector<PathPoint> GuessPath(const Scene& scene, const Eigen::Vector2d& uv) {
  std::vector<PathPoint> path;
  std::vector<Eigen::Vector2d> sites;
  std::vector<Eigen::Vector3d> values;
  for (std::size_t m = 0; m < scene.markers.size(); ++m) {
    const MarkerObservation& marker = scene.markers[m];
    if (!scene.is_fitted[marker.frame]) continue;
    sites.push_back(marker.on_cloth.At(scene.mesh.uv));
    values.push_back(marker.position);
    const bool is_last =
        m + 1 == scene.markers.size() || scene.markers[m + 1].frame != marker.frame;
    if (!is_last) continue;
    const std::optional<Eigen::Vector3d> position = SurfaceAt(sites, values, uv);
    if (position) path.push_back({scene.FrameTime(marker.frame), *position});
    sites.clear();
    values.clear();
  }
  return path;
}

}  // namespace clothfit
