// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/rigid_body.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

using Path = HandleDescription::Path;

constexpr size_t kLeastBodyMarkers = 3;  // fewer do not say how a body is turned
// By which markers of a body at rest may be off their mean, and the distances of one that is not
// declared may change. Motion capture is good to a millimetre; cloth moves by centimetres.
constexpr double kStill = 0.005;  // m

std::string PrefixOf(const std::string& name) {
  const size_t colon = name.find(':');
  return colon == std::string::npos ? "" : name.substr(0, colon);
}

bool KeepDistance(const Path& a, const Path& b) {
  double least = 1e300;
  double most = 0.0;
  for (size_t frame = 0; frame < a.size(); ++frame) {
    if (!a[frame] || !b[frame]) continue;
    const double distance = (*a[frame] - *b[frame]).norm();
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return most > 0.0 && most - least < kStill;
}

bool IsRigid(const std::vector<const MarkerPath*>& markers) {
  for (size_t i = 0; i < markers.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (!KeepDistance(markers[i]->positions, markers[j]->positions)) return false;
    }
  }
  return markers.size() >= kLeastBodyMarkers;
}

std::optional<Eigen::Vector3d> MeanPlace(const Path& path) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const auto& position : path) {
    if (position) sum += *position, ++count;
  }
  return count == 0.0 ? std::nullopt : std::optional<Eigen::Vector3d>(sum / count);
}

// The markers' mean places, where none is ever further from its own than kStill.
std::optional<std::vector<Eigen::Vector3d>> RestingPlaces(const RigidBody& body) {
  std::vector<Eigen::Vector3d> places;
  for (const MarkerPath& marker : body.markers) {
    const std::optional<Eigen::Vector3d> mean = MeanPlace(marker.positions);
    if (!mean) continue;
    places.push_back(*mean);
    for (const auto& position : marker.positions) {
      if (position && (*position - *mean).norm() > kStill) return std::nullopt;
    }
  }
  return places;
}

size_t NumSeenAt(const RigidBody& body, size_t frame) {
  return static_cast<size_t>(
      std::count_if(body.markers.begin(), body.markers.end(),
                    [&](const MarkerPath& marker) { return marker.positions[frame].has_value(); }));
}

// From the places of the markers at one frame to those at another, of the markers seen at both.
std::optional<Eigen::Isometry3d> MotionBetween(const RigidBody& body, size_t from, size_t to) {
  Eigen::Matrix3Xd before(3, body.markers.size());
  Eigen::Matrix3Xd after = before;
  Eigen::Index count = 0;
  for (const MarkerPath& marker : body.markers) {
    if (!marker.positions[from] || !marker.positions[to]) continue;
    before.col(count) = *marker.positions[from];
    after.col(count++) = *marker.positions[to];
  }
  if (count < static_cast<Eigen::Index>(kLeastBodyMarkers)) return std::nullopt;
  Eigen::Isometry3d motion;
  motion.matrix() = Eigen::umeyama(before.leftCols(count), after.leftCols(count), false);
  return motion;
}

[[noreturn]] void FailWithFewMarkers(const RigidBody& body) {
  throw InputError(body.name, "expected three markers of it or more in one frame");
}

}  // namespace

void TakeOutBodies(const std::set<std::string>& names, const std::vector<MarkerPath>& expected,
                   MarkerTake* take) {
  std::map<std::string, std::vector<const MarkerPath*>> groups;
  for (const MarkerPath& marker : take->markers) {
    groups[PrefixOf(marker.name)].push_back(&marker);
  }
  groups.erase("");
  std::set<std::string> bodies = names;
  for (const auto& [name, markers] : groups) {
    if (IsRigid(markers)) bodies.insert(name);
  }
  for (const std::string& name : bodies) {
    const auto is_of_body = [&](const MarkerPath& marker) { return PrefixOf(marker.name) == name; };
    RigidBody& body = take->bodies.emplace_back(RigidBody{name, {}});
    std::copy_if(expected.begin(), expected.end(), std::back_inserter(body.markers), is_of_body);
    std::vector<MarkerPath>& markers = take->markers;
    const auto measured = std::stable_partition(
        markers.begin(), markers.end(), [&](const auto& marker) { return !is_of_body(marker); });
    if (body.markers.empty()) body.markers.assign(measured, markers.end());
    markers.erase(measured, markers.end());
  }
}

RigidMotion FindRigidMotion(const RigidBody& body) {
  RigidMotion motion;
  if (const auto places = RestingPlaces(body)) {
    motion.reference = *places;
    if (places->size() < kLeastBodyMarkers) FailWithFewMarkers(body);
    return motion;
  }
  const size_t num_frames = body.markers.front().positions.size();
  size_t fullest = 0;
  for (size_t frame = 1; frame < num_frames; ++frame) {
    if (NumSeenAt(body, frame) > NumSeenAt(body, fullest)) fullest = frame;
  }
  for (const MarkerPath& marker : body.markers) {
    if (marker.positions[fullest]) motion.reference.push_back(*marker.positions[fullest]);
  }
  if (motion.reference.size() < kLeastBodyMarkers) FailWithFewMarkers(body);
  std::vector<std::optional<Eigen::Isometry3d>> found;
  for (size_t frame = 0; frame < num_frames; ++frame) {
    found.push_back(MotionBetween(body, fullest, frame));
  }
  motion.num_lost = int(std::count(found.begin(), found.end(), std::nullopt));
  const auto first =
      std::find_if(found.begin(), found.end(), [](const auto& m) { return bool(m); });
  motion.path.assign(1, **first);
  for (size_t frame = 1; frame < num_frames; ++frame) {
    motion.path.push_back(found[frame].value_or(motion.path.back()));
  }
  return motion;
}

}  // namespace clothfit
