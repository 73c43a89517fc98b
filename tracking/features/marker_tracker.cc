// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/marker_tracker.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <opencv2/core.hpp>

namespace clothfit {

using Eigen::Vector2d;

namespace {

// Frames for which a motion is believed to go on, and what is lost to stray.
constexpr int kLongestMotion = 3;
// px: nearer than this features are one, at other scales or orientations.
constexpr double kSamePlace = 3.0;

}  // namespace

MarkerTracker::MarkerTracker(std::vector<Camera> cameras, double frame_rate,
                             const MarkerTrackerOptions& options)
    : cameras_(std::move(cameras)), frame_rate_(frame_rate), options_(options) {}

std::vector<TrackedMarker> MarkerTracker::Start(
    const std::vector<Features>& views,
    const std::vector<std::vector<std::optional<Vector2d>>>& uv) {
  markers_.clear();
  counts_.clear();
  frame_ = 0;
  // Strongest features first, camera by camera; each joins the nearest marker that its view has no
  // part in yet, or begins one.
  for (int c = 0; c < static_cast<int>(views.size()); ++c) {
    for (int f = 0; f < views[c].size(); ++f) {
      if (!uv[c][f]) continue;
      TrackState* nearest = nullptr;
      double distance = std::numeric_limits<double>::infinity();
      for (TrackState& marker : markers_) {
        const double here = (marker.uv - *uv[c][f]).norm();
        if (here < distance) {
          distance = here;
          nearest = &marker;
        }
      }
      const View view{c, views[c].descriptors.row(f).clone(), views[c].descriptors.row(f).clone(),
                      views[c].pixels[f], 0};
      const bool is_seen = nearest != nullptr && nearest->views.back().camera == c;
      if (distance < options_.max_uv_distance && !is_seen) {
        double best = std::numeric_limits<double>::infinity();
        for (const View& other : nearest->views)
          best = std::min(best, cv::norm(view.reference, other.reference, cv::NORM_L2));
        if (best <= options_.max_view_descriptor_distance) {
          nearest->views.push_back(view);
          continue;
        }
        ++counts_["views differ"];
      }
      if (distance >= options_.min_marker_distance)
        markers_.push_back({*uv[c][f], {view}, std::nullopt, Eigen::Vector3d::Zero(), 0});
    }
  }
  markers_.erase(std::remove_if(markers_.begin(), markers_.end(),
                                [](const TrackState& m) { return m.views.size() < 2; }),
                 markers_.end());
  std::vector<TrackedMarker> found;
  for (int id = 0; id < static_cast<int>(markers_.size()); ++id) {
    std::vector<Sighting> sightings;
    for (const View& view : markers_[id].views) sightings.push_back({view.camera, view.pixel});
    const std::optional<TrackedMarker> marker = Place(id, sightings);
    if (!marker) continue;
    markers_[id].position = marker->position;
    const View& first = markers_[id].views.front();
    markers_[id].has_double = HasDouble(views[first.camera], first);
    found.push_back(*marker);
  }
  return found;
}

bool MarkerTracker::HasDouble(const Features& features, const View& view) const {
  for (int f = 0; f < features.size(); ++f) {
    if ((features.pixels[f] - view.pixel).norm() >= kSamePlace &&
        features.Distance(f, view.reference) <= options_.max_descriptor_distance) {
      return true;
    }
  }
  return false;
}

Eigen::Vector3d MarkerTracker::TrackState::Expected(int now) const {
  return *position + std::min(now - frame, kLongestMotion) * velocity;
}

MarkerTracker::Match MarkerTracker::FindAgain(const View& view, const TrackState& marker,
                                              const Features& features) {
  // Where the marker's motion leads, or else where the view saw it last.
  Vector2d expected = view.pixel;
  const Camera& camera = cameras_[view.camera];
  if (marker.position && marker.frame >= view.frame) {
    const Eigen::Vector3d place = marker.Expected(frame_);
    if (IsInFront(camera, place)) expected = ProjectPoint(camera, place);
  }
  const int since = frame_ - std::max(view.frame, marker.frame);
  const double gate = options_.max_image_move * std::min(since, kLongestMotion);
  const cv::Mat& descriptor =
      options_.reidentification == Reidentification::kReference ? view.reference : view.last;
  // All that can be meant at all; what is found there has no double anywhere near.
  constexpr double kReach = 10.0;  // gates
  Match match;
  if (!options_.check_image_move) {
    match.feature = MostAlike(features, descriptor, expected, kReach * gate);
    match.is_distinct = true;
    return match;
  }
  match.feature = MostAlike(features, descriptor, expected, gate);
  if (match.feature) {
    match.is_distinct =
        since > 1 && MostAlike(features, descriptor, expected, kReach * gate) == match.feature;
  } else {
    constexpr double kNearby = 3.0;  // gates: what is counted as thrown out
    if (MostAlike(features, descriptor, expected, kNearby * gate)) ++counts_["image move"];
  }
  return match;
}

std::optional<int> MarkerTracker::MostAlike(const Features& features, const cv::Mat& descriptor,
                                            const Vector2d& centre, double radius) const {
  int best = -1;
  double first = std::numeric_limits<double>::infinity(), second = first;
  for (int f = 0; f < features.size(); ++f) {
    if ((features.pixels[f] - centre).norm() > radius) continue;
    const double distance = features.Distance(f, descriptor);
    const bool same = best >= 0 && (features.pixels[f] - features.pixels[best]).norm() < kSamePlace;
    if (distance < first) {
      if (!same) second = first;
      first = distance;
      best = f;
    } else if (!same) {
      second = std::min(second, distance);
    }
  }
  if (best < 0 || first > options_.max_descriptor_distance || first > options_.max_ratio * second)
    return std::nullopt;
  return best;
}

std::vector<Sighting> MarkerTracker::Sight(TrackState* marker, const std::vector<Features>& views,
                                           std::vector<int>* features, int* num_distinct) {
  std::vector<Sighting> sightings;
  *num_distinct = 0;
  for (std::size_t v = 0; v < marker->views.size(); ++v) {
    const View& view = marker->views[v];
    const Features& seen = views[view.camera];
    const Match match = FindAgain(view, *marker, seen);
    if (!match.feature) {
      ++counts_["no feature"];
      continue;
    }
    sightings.push_back({view.camera, seen.pixels[*match.feature]});
    features->push_back(static_cast<int>(v));
    features->push_back(*match.feature);
    *num_distinct += match.is_distinct ? 1 : 0;
  }
  return sightings;
}

std::optional<TrackedMarker> MarkerTracker::Place(int id, const std::vector<Sighting>& sightings) {
  TrackedMarker marker;
  marker.id = id;
  marker.uv = markers_[id].uv;
  if (options_.check_reprojection || options_.place == MarkerPlace::kReprojection) {
    TriangulationOptions triangulation = options_.triangulation;
    if (!options_.check_reprojection) triangulation.gate = std::numeric_limits<double>::infinity();
    const std::optional<Triangulation> found =
        TriangulateRobustly(cameras_, sightings, triangulation);
    if (!found) {
      if (sightings.size() >= 2) ++counts_["reprojection"];
      return std::nullopt;
    }
    counts_["reprojection"] += static_cast<int>(sightings.size()) - found->num_agreeing;
    marker.position = found->position;
    marker.num_cameras = found->num_agreeing;
    if (options_.place == MarkerPlace::kReprojection) return marker;
    std::vector<PluckerRay<double>> rays;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      if (!found->agrees[i]) continue;
      const auto ray = RayThroughPixel(cameras_[sightings[i].camera], sightings[i].pixel);
      if (ray) rays.push_back(*ray);
    }
    const std::optional<Eigen::Vector3d> mean = MeanClosestPoint(rays);
    if (!mean) return std::nullopt;
    marker.position = *mean;
    return marker;
  }
  std::vector<PluckerRay<double>> rays;
  for (const Sighting& s : sightings) {
    const auto ray = RayThroughPixel(cameras_[s.camera], s.pixel);
    if (ray) rays.push_back(*ray);
  }
  const std::optional<Eigen::Vector3d> mean = MeanClosestPoint(rays);
  if (!mean) return std::nullopt;
  marker.position = *mean;
  marker.num_cameras = static_cast<int>(rays.size());
  return marker;
}

std::vector<TrackedMarker> MarkerTracker::Advance(const std::vector<Features>& views) {
  ++frame_;
  std::vector<TrackedMarker> found;
  std::vector<std::vector<int>> features_of;
  for (int id = 0; id < static_cast<int>(markers_.size()); ++id) {
    TrackState& state = markers_[id];
    std::vector<int> features;
    int num_distinct = 0;
    const std::vector<Sighting> sightings = Sight(&state, views, &features, &num_distinct);
    const std::optional<TrackedMarker> marker = Place(id, sightings);
    if (!marker) continue;
    const bool was_lost = state.position && state.frame != frame_ - 1;
    const bool is_distinct = num_distinct == static_cast<int>(sightings.size());
    const bool is_stale = state.frame < frame_ - kLongestMotion;
    const bool is_certain =
        is_stale ? is_distinct && !state.has_double
                 : is_distinct || marker->num_cameras >= options_.min_cameras_after_loss;
    if (was_lost && !is_certain) {
      ++counts_["ambiguous"];
      continue;
    }
    if (options_.check_world_move && state.position &&
        (marker->position - state.Expected(frame_)).norm() >
            options_.max_world_speed * (frame_ - state.frame) / frame_rate_) {
      ++counts_["world move"];
      continue;
    }
    found.push_back(*marker);
    features_of.push_back(std::move(features));
  }
  std::vector<bool> stays(found.size(), true);
  if (options_.check_distances) stays = VoteOnDistances(found, options_);
  std::vector<TrackedMarker> kept;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!stays[i]) {
      ++counts_["distances"];
      continue;
    }
    TrackState& state = markers_[found[i].id];
    if (state.position) {
      state.velocity = (found[i].position - *state.position) / std::max(1, frame_ - state.frame);
    }
    state.position = found[i].position;
    state.frame = frame_;
    for (std::size_t k = 0; k < features_of[i].size(); k += 2) {
      View& view = state.views[features_of[i][k]];
      const Features& seen = views[view.camera];
      const int feature = features_of[i][k + 1];
      // A view that the others contradict is not followed.
      if ((ProjectPoint(cameras_[view.camera], found[i].position) - seen.pixels[feature]).norm() >
          options_.triangulation.gate) {
        continue;
      }
      view.pixel = seen.pixels[feature];
      view.last = seen.descriptors.row(feature).clone();
      view.frame = frame_;
    }
    kept.push_back(found[i]);
  }
  return kept;
}

}  // namespace clothfit
