// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/attraction_targets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace clothfit {
namespace {

// The frame during whose step before it a time is.
int ComingFrame(double time, double frame_rate) {
  return static_cast<int>(std::ceil(time * frame_rate - 1e-6));
}

bool IsSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.nodes == b.nodes && a.weights == b.weights;
}

// What was seen of one marker, or of one track in one camera, by frame.
template <class Values>
using Sightings = std::map<int, std::pair<SurfacePoint, Values>>;

// Frames from one that is fitted to the next, where all in between are left out evenly; 1 where
// none are.
int FramesBetween(const Scene& scene) {
  int fewest = static_cast<int>(scene.is_fitted.size()), last = -1;
  for (int frame = 0; frame < static_cast<int>(scene.is_fitted.size()); ++frame) {
    if (!scene.is_fitted[static_cast<std::size_t>(frame)]) continue;
    if (last >= 0) fewest = std::min(fewest, frame - last);
    last = frame;
  }
  return std::max(1, fewest);
}

// The piece of so many equal ones, of a cubic in s from 0 to 1, by an s of its own.
template <class Values>
std::array<Values, 4> PieceOf(const std::array<Values, 4>& c, int piece, int pieces) {
  const double n = pieces, t = piece / n;
  return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), (c[1] + t * (2.0 * c[2] + 3.0 * t * c[3])) / n,
          (c[2] + 3.0 * t * c[3]) / (n * n), c[3] / (n * n * n)};
}

// The courses of one target, which is seen every `step` frames, each added to those that end at its
// frame.
template <class Values, class Course>
void AddCourses(const Sightings<Values>& seen, int step,
                std::vector<std::vector<Course>>* courses) {
  // Null where it was not seen in that frame, or elsewhere on the cloth.
  const auto at = [&](int frame, const SurfacePoint& on_cloth) -> const Values* {
    const auto found = seen.find(frame);
    const bool is_there = found != seen.end() && IsSame(found->second.first, on_cloth);
    return is_there ? &found->second.second : nullptr;
  };
  for (const auto& [frame, sighting] : seen) {
    const auto& [on_cloth, end] = sighting;
    const Values zero = Values::Zero();
    const Values* begin = at(frame - step, on_cloth);
    if (begin == nullptr) {
      (*courses)[frame].push_back({on_cloth, {end, zero, zero, zero}, false});
      continue;
    }
    const Values *earlier = at(frame - 2 * step, on_cloth), *later = at(frame + step, on_cloth);
    const Values across = end - *begin;
    const Values first = earlier != nullptr ? Values(0.5 * (end - *earlier)) : across;
    const Values last = later != nullptr ? Values(0.5 * (*later - *begin)) : across;
    const std::array<Values, 4> whole = {*begin, first, 3.0 * across - 2.0 * first - last,
                                         first + last - 2.0 * across};
    for (int piece = 0; piece < step; ++piece)
      (*courses)[frame - step + 1 + piece].push_back({on_cloth, PieceOf(whole, piece, step), true});
  }
}

}  // namespace

void AddAttractionTargets(const Scene& scene, int frame, StepInputs* inputs) {
  const auto before = [](const auto& observation, int f) { return observation.frame < f; };
  auto marker = std::lower_bound(scene.markers.begin(), scene.markers.end(), frame, before);
  for (; marker != scene.markers.end() && marker->frame == frame && scene.is_fitted[frame];
       ++marker) {
    inputs->points.push_back({marker->on_cloth, marker->position, {}});
  }
  auto track = std::lower_bound(scene.tracks.begin(), scene.tracks.end(), frame, before);
  for (; track != scene.tracks.end() && track->frame == frame; ++track) {
    if (scene.IsFitted(*track) && track->ray)
      inputs->rays.push_back({track->on_cloth, track->ray->direction, track->ray->moment, {}});
  }
}

AttractionCourses::AttractionCourses(const Scene& scene)
    : scene_(scene),
      frame_rate_(scene.recording.frame_rate),
      points_(scene.is_fitted.size()),
      rays_(scene.is_fitted.size()) {
  if (scene.clouds) surface_.emplace(scene.mesh.triangles, scene.initial);
  std::map<int, Sightings<Eigen::Vector3d>> markers;
  for (const MarkerObservation& marker : scene.markers) {
    if (scene.is_fitted[static_cast<std::size_t>(marker.frame)])
      markers[marker.id].insert({marker.frame, {marker.on_cloth, marker.position}});
  }
  const int step = FramesBetween(scene);
  for (const auto& [id, seen] : markers) AddCourses(seen, step, &points_);
  std::map<std::pair<int, int>, Sightings<Eigen::Matrix<double, 6, 1>>> tracks;
  for (const TrackObservation& track : scene.tracks) {
    if (!scene.IsFitted(track) || !track.ray) continue;
    Eigen::Matrix<double, 6, 1> ray;
    ray << track.ray->direction, track.ray->moment;
    tracks[{track.camera, track.id}].insert({track.frame, {track.on_cloth, ray}});
  }
  for (const auto& [camera_and_id, seen] : tracks) AddCourses(seen, step, &rays_);
}

void AttractionCourses::Approach(int frame, const Eigen::VectorXd& x) {
  of_clouds_.clear();
  if (!surface_) return;
  surface_->MoveTo(x);
  for (const CloudObservation& cloud : scene_.clouds->observations) {
    if (cloud.frame != frame || !scene_.IsFitted(cloud)) continue;
    for (const Eigen::Vector3d& point : cloud.points) {
      const auto [triangle, closest] = surface_->Find(point);
      of_clouds_.push_back({{scene_.mesh.triangles[triangle], closest.weights}, point, {}});
    }
  }
}

void AttractionCourses::AddTargets(double time, StepInputs* inputs) const {
  const int frame = ComingFrame(time, frame_rate_);
  if (frame < 0 || frame >= static_cast<int>(points_.size())) return;
  inputs->points.insert(inputs->points.end(), of_clouds_.begin(), of_clouds_.end());
  const double s = std::clamp(time * frame_rate_ - (frame - 1), 0.0, 1.0);
  const auto value = [s](const auto& c) {
    return (c[0] + s * (c[1] + s * (c[2] + s * c[3]))).eval();
  };
  const auto rate = [s, this](const auto& c) {
    return (frame_rate_ * (c[1] + s * (2.0 * c[2] + 3.0 * s * c[3]))).eval();
  };
  for (const PointCourse& course : points_[static_cast<std::size_t>(frame)]) {
    inputs->points.push_back({course.on_cloth, value(course.coefficients), {}});
    if (course.is_known) inputs->points.back().velocity = rate(course.coefficients);
  }
  for (const RayCourse& course : rays_[static_cast<std::size_t>(frame)]) {
    // A camera's rays all go through its centre, and so does what lies linearly between them.
    const Eigen::Matrix<double, 6, 1> ray = value(course.coefficients);
    const double length = ray.head<3>().norm();
    const Eigen::Vector3d direction = ray.head<3>() / length, moment = ray.tail<3>() / length;
    inputs->rays.push_back({course.on_cloth, direction, moment, {}});
    if (!course.is_known) continue;
    const Eigen::Matrix<double, 6, 1> moving = rate(course.coefficients) / length;
    const double lengthening = direction.dot(moving.head<3>());
    inputs->rays.back().rates = RayTarget::Rates{moving.head<3>() - lengthening * direction,
                                                 moving.tail<3>() - lengthening * moment};
  }
}

}  // namespace clothfit
