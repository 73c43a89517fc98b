// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "tracking/recording/surface/initial_placement.h"

namespace clothfit {
namespace {

// A point of the cloth seen at one frame.
struct WatchedPoint {
  std::string label;
  Eigen::Vector2d uv;        // m
  Eigen::Vector3d position;  // m, world
  double sigma;              // m
};

// Markers and handles of known position, by frame.
std::map<int, std::vector<WatchedPoint>> WatchedPoints(const Recording& recording) {
  std::map<int, std::vector<WatchedPoint>> points;
  const double marker_sigma = recording.noise.marker.value_or(kDefaultMarkerSigma);
  for (const Marker& marker : recording.markers) {
    points[marker.frame].push_back(
        {fmt::format("marker {}", marker.id), marker.uv, marker.position, marker_sigma});
  }
  for (const HandleDescription& handle : recording.handles) {
    if (!handle.path) continue;
    const int last = handle.released_after.value_or(recording.frame_count - 1);
    for (int frame = 0; frame <= last; ++frame) {
      const std::optional<Eigen::Vector3d>& position = (*handle.path)[static_cast<size_t>(frame)];
      if (!position) continue;
      points[frame].push_back({"handle " + handle.name, handle.uv, *position,
                               handle.path_sigma.value_or(kDefaultPathSigma)});
    }
  }
  return points;
}

// Points cannot be farther apart in space than on the cloth, but for stretch and noise.
void WarnOfStretch(const Recording& recording, std::vector<std::string>* warnings) {
  constexpr size_t kMaxPoints = 100;  // in a frame; pairs of more would take long
  int frame_count = 0;
  double worst = 0.0;
  std::string worst_pair;
  for (const auto& [frame, points] : WatchedPoints(recording)) {
    bool exceeded = false;
    const size_t count = std::min(points.size(), kMaxPoints);
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = i + 1; j < count; ++j) {
        const double on_cloth = (points[i].uv - points[j].uv).norm();
        const double in_space = (points[i].position - points[j].position).norm();
        const double slack = 3.0 * std::hypot(points[i].sigma, points[j].sigma);
        if (on_cloth <= 0.0 || in_space <= kUnlikelyStretch * on_cloth + slack) continue;
        exceeded = true;
        if (in_space / on_cloth <= worst) continue;
        worst = in_space / on_cloth;
        worst_pair = fmt::format("{} and {} at frame {}: {:.4f} m apart, {:.4f} m on the cloth",
                                 points[i].label, points[j].label, frame, in_space, on_cloth);
      }
    }
    if (exceeded) ++frame_count;
  }
  if (frame_count == 0) return;
  warnings->push_back(fmt::format(
      "points are more than 10 % farther apart than on the cloth in {} frames (worst: {}); wrong "
      "(u, v), swapped ids or outliers?",
      frame_count, worst_pair));
}

// From one frame to the next a marker can hardly cross a good part of the cloth.
void WarnOfJumps(const Recording& recording, std::vector<std::string>* warnings) {
  const double limit = 0.25 * recording.cloth.size.maxCoeff();
  std::map<std::pair<int, int>, const Marker*> by_id_and_frame;
  for (const Marker& marker : recording.markers) {
    by_id_and_frame[{marker.id, marker.frame}] = &marker;
  }
  int count = 0;
  std::string first;
  std::set<int> moved_on_cloth;
  const Marker* previous = nullptr;
  for (const auto& [key, marker] : by_id_and_frame) {
    if (previous != nullptr && previous->id == marker->id) {
      const double distance = (marker->position - previous->position).norm();
      if (marker->frame == previous->frame + 1 && distance > limit && count++ == 0) {
        first =
            fmt::format("marker {} by {:.3f} m to frame {}", marker->id, distance, marker->frame);
      }
      if (marker->uv != previous->uv) moved_on_cloth.insert(marker->id);
    }
    previous = marker;
  }
  if (count > 0) {
    warnings->push_back(
        fmt::format("markers jump {} times between frames (first: {})", count, first));
  }
  if (!moved_on_cloth.empty()) {
    warnings->push_back(
        fmt::format("{} markers change their (u, v) between frames (first: marker {})",
                    moved_on_cloth.size(), *moved_on_cloth.begin()));
  }
}

void WarnOfInitialStretch(const Recording& recording, std::vector<std::string>* warnings) {
  const auto* placement = std::get_if<PointPlacement>(&recording.cloth.initial);
  if (placement == nullptr) return;
  const std::vector<PlacedPoint>& points = placement->points;
  double worst = kUnlikelyStretch;
  std::string worst_pair;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = i + 1; j < points.size(); ++j) {
      const double stretch =
          (points[i].position - points[j].position).norm() / (points[i].uv - points[j].uv).norm();
      if (stretch <= worst) continue;
      worst = stretch;
      worst_pair = fmt::format("(u, v) = ({}, {}) and ({}, {})", points[i].uv.x(), points[i].uv.y(),
                               points[j].uv.x(), points[j].uv.y());
    }
  }
  if (worst_pair.empty()) return;
  warnings->push_back(fmt::format(
      "the initial points are up to {:.0f} % farther apart than on the cloth: {}; the cloth starts "
      "under tension",
      100.0 * (worst - 1.0), worst_pair));
}

void WarnOfGround(const Recording& recording, std::vector<std::string>* warnings) {
  if (std::holds_alternative<MeshPlacement>(recording.cloth.initial)) return;
  if (!recording.ground_height) return;
  const Eigen::Vector2d& size = recording.cloth.size;
  double lowest = *recording.ground_height;
  for (const Eigen::Vector3d& corner :
       InitialPositions(recording, {{0.0, 0.0}, {size.x(), 0.0}, {0.0, size.y()}, size})) {
    lowest = std::min(lowest, corner.z());
  }
  if (lowest < *recording.ground_height) {
    warnings->push_back(fmt::format("the initial placement reaches {:.4f} m below the ground",
                                    *recording.ground_height - lowest));
  }
}

}  // namespace

void WarnOfPoints(const Recording& recording, std::vector<std::string>* warnings) {
  WarnOfStretch(recording, warnings);
  WarnOfJumps(recording, warnings);
  WarnOfInitialStretch(recording, warnings);
  WarnOfGround(recording, warnings);
}

}  // namespace clothfit
