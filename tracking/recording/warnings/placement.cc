// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/placement.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/mesh/surface_point.h"
#include "tracking/recording/surface/initial_placement.h"
#include "tracking/recording/warnings/silhouette.h"

namespace clothfit {
namespace {

using Places = std::vector<Eigen::Vector3d>;

constexpr size_t kLeastPoints = 4;   // fewer have no median to speak of, and fit any shift
constexpr size_t kMostPoints = 400;  // of a kind; more tell nothing new
constexpr double kFarBetter = 1.0 / 3.0;
constexpr double kTie = 1e-6;  // m; below it the simpler of two explanations is taken

// m, world, at frame 0.
Places PlacedAt(const Recording& recording, const std::vector<Eigen::Vector2d>& uv) {
  if (!std::holds_alternative<MeshPlacement>(recording.cloth.initial))
    return InitialPositions(recording, uv);
  const PlacedCloth cloth = PlaceCloth(recording);
  Places positions;
  for (const SurfacePoint& point : LocateOnCloth(cloth.mesh, uv))
    positions.push_back(point.At(cloth.x));
  return positions;
}

std::pair<int, int> Identity(const Marker& marker) { return {0, marker.id}; }
std::pair<int, int> Identity(const Track& track) { return {track.camera, track.id}; }

// The first sight of each point that is seen soon; at most kMostPoints, spread over all of them.
template <class Sight>
std::vector<Sight> FirstSights(const Recording& recording, const std::vector<Sight>& sights) {
  std::map<std::pair<int, int>, const Sight*> by_point;
  for (const Sight& sight : sights) {
    if (sight.frame > kFirstSeenWithin * recording.frame_rate) continue;
    const Sight*& first = by_point[Identity(sight)];
    if (first == nullptr || sight.frame < first->frame) first = &sight;
  }
  const size_t stride = 1 + by_point.size() / kMostPoints;
  std::vector<Sight> firsts;
  size_t count = 0;
  for (const auto& [point, first] : by_point)
    if (count++ % stride == 0) firsts.push_back(*first);
  return firsts;
}

// How far (m) a point was seen from where it is placed; of a track across the camera's view, at the
// depth of the place, or from the camera where that is behind it.
double DistanceOff(const Recording&, const Marker& marker, const Eigen::Vector3d& placed) {
  return (marker.position - placed).norm();
}
double DistanceOff(const Recording& recording, const Track& track, const Eigen::Vector3d& placed) {
  const Camera& camera = recording.cameras[static_cast<size_t>(track.camera)];
  if (!IsInFront(camera, placed)) return (placed - CameraCentre(camera)).norm();
  const double depth = CameraFromWorld<double>(camera, placed).z();
  return (ProjectPoint(camera, placed) - track.pixel).norm() * depth / camera.fx;
}

// m, by which a point may be off; that of tracks is far above their noise.
double Tolerance(const Recording& recording) {
  return kPlacementTolerance * recording.cloth.size.maxCoeff();
}
double Tolerance(const Recording& recording, const Marker&) {
  return Tolerance(recording) + 3.0 * recording.noise.marker.value_or(kDefaultMarkerSigma);
}
double Tolerance(const Recording& recording, const Track&) { return Tolerance(recording); }

// m, by which the cloth may have fallen until then.
double Fall(const Recording& recording, int frame) {
  const double seconds = frame / recording.frame_rate;
  return 0.5 * recording.gravity.norm() * seconds * seconds;
}

double MiddleOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The symmetries of a rectangle, by their bits: 1 reverses u, 2 reverses v, 4 exchanges them
// before.
constexpr std::array<const char*, 8> kSymmetries = {"",
                                                    "with u reversed",
                                                    "with v reversed",
                                                    "with u and v reversed",
                                                    "with u and v exchanged",
                                                    "with u and v exchanged, then u reversed",
                                                    "with u and v exchanged, then v reversed",
                                                    "with u and v exchanged, then both reversed"};

Eigen::Vector2d Applied(unsigned symmetry, Eigen::Vector2d uv, Eigen::Vector2d size) {
  if ((symmetry & 4u) != 0) {
    std::swap(uv.x(), uv.y());
    std::swap(size.x(), size.y());
  }
  if ((symmetry & 1u) != 0) uv.x() = size.x() - uv.x();
  if ((symmetry & 2u) != 0) uv.y() = size.y() - uv.y();
  return uv;
}

// What would bring the start to the points.
struct Remedy {
  unsigned symmetry = 0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // m, world
  double median = 0.0;                              // m, that is left
};

template <class Sight>
double MedianOff(const Recording& recording, const std::vector<Sight>& sights, const Places& placed,
                 const Eigen::Vector3d& shift) {
  std::vector<double> off;
  for (size_t i = 0; i < sights.size(); ++i)
    off.push_back(DistanceOff(recording, sights[i], placed[i] + shift));
  return MiddleOf(std::move(off));
}

Eigen::Vector3d MedianShift(const std::vector<Marker>& markers, const Places& placed) {
  Eigen::Vector3d shift;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> differences;
    for (size_t i = 0; i < markers.size(); ++i)
      differences.push_back(markers[i].position[k] - placed[i][k]);
    shift[k] = MiddleOf(std::move(differences));
  }
  return shift;
}

// The one that leaves least; one that shifts the cloth, too, only where it leaves far less.
template <class Sight>
Remedy BestRemedy(const Recording& recording, const std::vector<Sight>& sights) {
  std::vector<Eigen::Vector2d> uv;
  for (unsigned symmetry = 0; symmetry < kSymmetries.size(); ++symmetry)
    for (const Sight& sight : sights)
      uv.push_back(Applied(symmetry, sight.uv, recording.cloth.size));
  const Places all = PlacedAt(recording, uv);
  Remedy best{0, Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
  Remedy best_shifted = best;
  const auto consider = [](const Remedy& remedy, Remedy* least) {
    if (remedy.median < least->median - kTie) *least = remedy;
  };
  for (unsigned symmetry = 0; symmetry < kSymmetries.size(); ++symmetry) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(symmetry * sights.size());
    const Places placed(begin, begin + static_cast<std::ptrdiff_t>(sights.size()));
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    consider({symmetry, zero, MedianOff(recording, sights, placed, zero)}, &best);
    if constexpr (std::is_same_v<Sight, Marker>) {
      const Eigen::Vector3d shift = MedianShift(sights, placed);
      consider({symmetry, shift, MedianOff(recording, sights, placed, shift)}, &best_shifted);
    }
  }
  return best_shifted.median < kFarBetter * best.median ? best_shifted : best;
}

std::string DescribeRemedy(const Remedy& remedy) {
  const Eigen::Array3d shift = (1000.0 * remedy.shift.array()).round() / 1000.0 + 0.0;  // no "-0"
  std::string how = kSymmetries[remedy.symmetry];
  if (!shift.isZero()) {
    how += fmt::format("{}moved by ({}, {}, {}) m", how.empty() ? "" : ", ", shift.x(), shift.y(),
                       shift.z());
  }
  return "; the start would fit them " + how;
}

// Whether these are misplaced.
template <class Sight>
bool WarnOfKind(const Recording& recording, const std::vector<Sight>& all, const char* kind,
                std::vector<std::string>* warnings) {
  const std::vector<Sight> sights = FirstSights(recording, all);
  if (sights.size() < kLeastPoints) return false;
  std::vector<Eigen::Vector2d> uv;
  for (const Sight& sight : sights) uv.push_back(sight.uv);
  const Places placed = PlacedAt(recording, uv);
  const double tolerance = Tolerance(recording, sights.front());
  size_t far = 0;
  for (size_t i = 0; i < sights.size(); ++i)
    if (DistanceOff(recording, sights[i], placed[i]) > tolerance + Fall(recording, sights[i].frame))
      ++far;
  const auto count = static_cast<double>(sights.size());
  if (static_cast<double>(far) <= kMisplacedShare * count) return false;
  const double median = MedianOff(recording, sights, placed, Eigen::Vector3d::Zero());
  const Remedy remedy = BestRemedy(recording, sights);
  const bool helps = remedy.median < kFarBetter * median && remedy.median < tolerance;
  warnings->push_back(fmt::format(
      "{} of {} {} begin farther than {:.3f} m from where the cloth's start has them, by {:.3f} m "
      "in "
      "the median{}: check cloth.initial, and from which corner u and v run",
      far, sights.size(), kind, tolerance, median, helps ? DescribeRemedy(remedy) : ""));
  return true;
}

void WarnOfPaths(const Recording& recording, std::vector<std::string>* warnings) {
  std::vector<Eigen::Vector2d> uv;
  for (const HandleDescription& handle : recording.handles) uv.push_back(handle.uv);
  if (uv.empty()) return;
  const Places placed = PlacedAt(recording, uv);
  for (size_t i = 0; i < uv.size(); ++i) {
    const HandleDescription& handle = recording.handles[i];
    if (!handle.path || !handle.path->front()) continue;
    const double off = (*handle.path->front() - placed[i]).norm();
    const double noise = 3.0 * handle.path_sigma.value_or(kDefaultPathSigma);
    if (off <= Tolerance(recording) + noise) continue;
    warnings->push_back(fmt::format(
        "handle {}: its path begins {:.3f} m from where the cloth's start has its (u, v)",
        handle.name, off));
  }
}

}  // namespace

void WarnOfPlacement(const Recording& recording, std::vector<std::string>* warnings) {
  const bool markers = WarnOfKind(recording, recording.markers, "markers", warnings);
  const bool tracks = WarnOfKind(recording, recording.tracks, "tracks", warnings);
  if (markers || tracks) return;
  WarnOfSilhouettes(recording, warnings);
  WarnOfPaths(recording, warnings);
}

}  // namespace clothfit
