// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/outliers/outliers.h"

#include <algorithm>
#include <map>
#include <queue>
#include <utility>

#include <fmt/format.h>

#include "tracking/outliers/swapped_markers.h"
#include "tracking/outliers/unexplained.h"
#include "tracking/recording/warnings/points.h"

namespace clothfit {
namespace {

constexpr double kDistanceSigmas = 6.0;  // of the distance of two points
// Calibrated on three recordings of another program with planted errors of 80 mm and more and noise
// of 2 mm: what was neither an error nor beside one stayed below 6.
constexpr double kUnusual = 10.0;
constexpr double kGross = 5.0;       // sigmas
constexpr int kOften = 3;            // errors of one id that make it a wrong label,
constexpr double kOftenShare = 0.1;  // where they are more than this share of its frames
constexpr int kEnough = 3;           // neighbours that can contradict a point

// The errors of one kind of points, as by how much each is off; 0: not at all.
using Errors = std::vector<double>;

// How far a point lies beyond where a neighbour lets it be; 0 or less: not at all.
double Beyond(const ObservedPoint& a, const ObservedPoint& b, double sigma) {
  return (a.position - b.position).norm() - kUnlikelyStretch * (a.uv - b.uv).norm() -
         kDistanceSigmas * sigma;
}

Errors ImpossibleDistances(const std::vector<ObservedPoint>& points, double sigma) {
  const std::vector<std::vector<int>> neighbours = NearestOfFrame(points);
  const int count = static_cast<int>(points.size());
  const auto is_most = [](int some, std::size_t all) {
    return static_cast<int>(all) >= kEnough && 2 * some >= static_cast<int>(all);
  };
  std::vector<bool> is_contradicted(points.size());
  for (int i = 0; i < count; ++i) {
    int against = 0;
    for (const int j : neighbours[i]) against += Beyond(points[i], points[j], sigma) > 0.0 ? 1 : 0;
    is_contradicted[i] = is_most(against, neighbours[i].size());
  }
  Errors errors(points.size(), 0.0);
  for (int i = 0; i < count; ++i) {
    if (!is_contradicted[i]) continue;
    int against = 0;
    double off = 0.0;
    for (const int j : neighbours[i]) {
      const double beyond = Beyond(points[i], points[j], sigma);
      if (beyond <= 0.0 || is_contradicted[j]) continue;
      ++against;
      off = std::max(off, beyond);
    }
    if (is_most(against, neighbours[i].size())) errors[i] = off;
  }
  return errors;
}

// The largest first, as each changes what is expected of those beside it.
Errors UnexplainedJumps(const std::vector<ObservedPoint>& points, double sigma) {
  Errors errors(points.size(), 0.0);
  Unexplained unexplained(points);
  std::priority_queue<std::pair<double, int>> worst;  // by size
  const auto add = [&](int i) {
    const double size = unexplained.Size(i);
    if (size > kGross * sigma && size > kUnusual * unexplained.Usual(i)) worst.push({size, i});
  };
  for (int i = 0; i < static_cast<int>(points.size()); ++i) add(i);
  while (!worst.empty()) {
    const auto [size, i] = worst.top();
    worst.pop();
    if (unexplained.Size(i) != size) continue;  // of before something beside it was left out
    errors[i] = size;
    for (const int j : unexplained.LeaveOut(i)) add(j);
  }
  return errors;
}

// A wrong label or (u, v) is found again and again, a gross error hardly.
void KeepWhatIsAlwaysOff(const std::vector<ObservedPoint>& points, Errors* errors) {
  std::map<int, std::pair<int, int>> off_of;  // by id: how many are off, and of how many
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& [off, all] = off_of[points[i].id];
    off += (*errors)[i] > 0.0 ? 1 : 0;
    ++all;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [off, all] = off_of.at(points[i].id);
    if (off > kOften && off > kOftenShare * all) (*errors)[i] = 0.0;
  }
}

Errors FindErrors(const std::vector<ObservedPoint>& points, double sigma, bool in_space) {
  Errors errors(points.size(), 0.0);
  std::vector<ObservedPoint> rest;
  std::vector<std::size_t> index;
  if (in_space) {
    errors = ImpossibleDistances(points, sigma);
    KeepWhatIsAlwaysOff(points, &errors);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (errors[i] > 0.0) continue;
    rest.push_back(points[i]);
    index.push_back(i);
  }
  Errors jumps = UnexplainedJumps(rest, sigma);
  KeepWhatIsAlwaysOff(rest, &jumps);
  for (std::size_t k = 0; k < rest.size(); ++k)
    errors[index[k]] = std::max(errors[index[k]], jumps[k]);
  return errors;
}

// Moves what is off from `all` to `out`. errors: by index into `all`.
template <class Point>
void MoveOut(const Errors& errors, std::vector<Point>* all, std::vector<Outlier>* out) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < all->size(); ++i) {
    if (errors[i] > 0.0) {
      out->push_back({(*all)[i], errors[i]});
    } else {
      kept.push_back((*all)[i]);
    }
  }
  *all = std::move(kept);
}

}  // namespace

void LeaveOutOutliers(Recording* recording) {
  PutLabelsRight(recording);
  std::vector<Outlier>& out = recording->left_out;
  std::vector<ObservedPoint> points;
  for (const Marker& m : recording->markers) points.push_back({m.frame, m.id, m.uv, m.position});
  const double marker_sigma = recording->noise.marker.value_or(kDefaultMarkerSigma);
  MoveOut(FindErrors(points, marker_sigma, true), &recording->markers, &out);
  std::map<int, std::vector<std::size_t>> by_camera;
  for (std::size_t i = 0; i < recording->tracks.size(); ++i)
    by_camera[recording->tracks[i].camera].push_back(i);
  Errors of_tracks(recording->tracks.size(), 0.0);
  const double track_sigma = recording->noise.track.value_or(kDefaultTrackSigma);
  for (const auto& [camera, tracks] : by_camera) {
    points.clear();
    for (const std::size_t i : tracks) {
      const Track& t = recording->tracks[i];
      points.push_back({t.frame, t.id, t.uv, {t.pixel.x(), t.pixel.y(), 0.0}});
    }
    const Errors errors = FindErrors(points, track_sigma, false);
    for (std::size_t k = 0; k < tracks.size(); ++k) of_tracks[tracks[k]] = errors[k];
  }
  MoveOut(of_tracks, &recording->tracks, &out);
  std::stable_sort(out.begin(), out.end(), [](const Outlier& a, const Outlier& b) {
    return a.IsMarker() != b.IsMarker() ? a.IsMarker() : a.off > b.off;
  });
}

std::string DescribeOutliers(const Recording& recording) {
  const std::vector<Outlier>& out = recording.left_out;
  if (out.empty()) return "";
  const auto first_track =
      std::find_if(out.begin(), out.end(), [](const Outlier& o) { return !o.IsMarker(); });
  const auto markers = first_track - out.begin(), tracks = out.end() - first_track;
  std::vector<std::string> parts;
  if (markers > 0) {
    const Marker& m = std::get<Marker>(out.front().point);
    parts.push_back(fmt::format("{} of {} markers (worst: marker {} at frame {}, {:.3f} m off)",
                                markers, recording.markers.size() + markers, m.id, m.frame,
                                out.front().off));
  }
  if (tracks > 0) {
    const Track& t = std::get<Track>(first_track->point);
    parts.push_back(fmt::format(
        "{} of {} tracked points (worst: {} in camera {} at frame {}, {:.0f} px off)", tracks,
        recording.tracks.size() + tracks, t.id,
        recording.cameras[static_cast<std::size_t>(t.camera)].name, t.frame, first_track->off));
  }
  return fmt::format("{}", fmt::join(parts, " and "));
}

}  // namespace clothfit
