// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/held_markers.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

constexpr double kGravity = 9.81;  // m/s^2

// The distance of a vector from the cone that these unit directions span: least squares with
// coefficients that are not negative, one coefficient at a time.
double DistanceFromCone(const Eigen::Vector3d& vector,
                        const std::vector<Eigen::Vector3d>& directions) {
  constexpr int kMostRounds = 500;
  constexpr double kTolerance = 1e-6;  // of the vector
  std::vector<double> amounts(directions.size(), 0.0);
  Eigen::Vector3d rest = vector;
  for (int round = 0; round < kMostRounds; ++round) {
    double largest_change = 0.0;
    for (size_t k = 0; k < directions.size(); ++k) {
      const double amount = std::max(amounts[k] + rest.dot(directions[k]), 0.0);
      rest -= (amount - amounts[k]) * directions[k];
      largest_change = std::max(largest_change, std::abs(amount - amounts[k]));
      amounts[k] = amount;
    }
    if (largest_change < kTolerance * vector.norm()) break;
  }
  return rest.norm();
}

// From the marker to the others. The cloth may leave it a little more steeply than the straight
// line: bending keeps an edge between two hands from sagging as a chain would.
std::vector<Eigen::Vector3d> Pulls(const MarkerTake& take, size_t marker, size_t frame) {
  constexpr double kSteeper = 0.1;  // slope; six degrees
  std::vector<Eigen::Vector3d> directions;
  const Eigen::Vector3d& place = *take.markers[marker].positions[frame];
  for (size_t other = 0; other < take.markers.size(); ++other) {
    const auto& position = take.markers[other].positions[frame];
    if (other == marker || !position) continue;
    const Eigen::Vector3d along = *position - place;
    if (along.norm() < 1e-6) continue;
    directions.push_back((along + kSteeper * along.norm() * Eigen::Vector3d::UnitZ()).normalized());
  }
  return directions;
}

// Over the first frames whose accelerations can be told: by second differences over `step` frames.
double MeanSupport(const MarkerTake& take, size_t marker, size_t step, size_t num_frames) {
  const HandleDescription::Path& path = take.markers[marker].positions;
  const double time = double(step) / take.frame_rate;
  double sum = 0.0;
  int count = 0;
  for (size_t frame = step; frame < num_frames && frame + step < path.size(); ++frame) {
    if (!path[frame - step] || !path[frame] || !path[frame + step]) continue;
    const Eigen::Vector3d acceleration =
        (*path[frame - step] - 2.0 * *path[frame] + *path[frame + step]) / (time * time);
    const Eigen::Vector3d force = acceleration / kGravity + Eigen::Vector3d::UnitZ();
    sum += DistanceFromCone(force, Pulls(take, marker, frame));
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

}  // namespace

std::vector<double> SupportAtStart(const MarkerTake& take) {
  constexpr double kStepTime = 0.05;  // s: a millimetre of jitter is 0.1 g then
  const auto step = static_cast<size_t>(std::max(std::lround(kStepTime * take.frame_rate), 1L));
  const auto num_frames = std::max(static_cast<size_t>(kSupportTime * take.frame_rate), step + 1);
  std::vector<double> support;
  for (size_t marker = 0; marker < take.markers.size(); ++marker) {
    support.push_back(MeanSupport(take, marker, step, num_frames));
  }
  return support;
}

std::vector<size_t> FindHeldMarkers(const std::vector<double>& support, const MarkerTake& take) {
  constexpr double kHigher = 0.1;  // of the extent
  Eigen::AlignedBox3d extent;
  for (const MarkerPath& marker : take.markers) extent.extend(*marker.positions.front());
  const double least_height = extent.min().z() + kHigher * extent.diagonal().norm();
  std::vector<size_t> held;
  for (size_t i = 0; i < support.size(); ++i) {
    const double height = take.markers[i].positions.front()->z();
    if (support[i] >= kHeldSupport && height >= least_height) held.push_back(i);
  }
  return held;
}

}  // namespace clothfit
