// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/synthesis_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothfit {

SynthesisError::SynthesisError(const Scene& scene, const FitConfig& config)
    : scene_(scene),
      alpha_(config.FitsSilhouettes() ? config.alpha : 0.0),
      beta_(config.FitsMarkers() || config.FitsTracks() || config.FitsClouds() ? config.beta : 0.0),
      hard_(scene),
      clouds_(scene, 0.0) {
  for (const TrackObservation& track : scene.tracks) {
    PluckerRay<double> none;
    none.direction.setZero();
    none.moment.setZero();
    rays_.push_back(
        RayThroughPixel(scene.recording.cameras[track.camera], track.pixel).value_or(none));
  }
}

double SynthesisError::MeanAttractor(int frame, const Eigen::VectorXd& x) const {
  const auto before = [](const auto& observation, int f) { return observation.frame < f; };
  double sum = 0.0;
  int count = 0;
  auto marker = std::lower_bound(scene_.markers.begin(), scene_.markers.end(), frame, before);
  for (; marker != scene_.markers.end() && marker->frame == frame; ++marker, ++count) {
    sum += (marker->on_cloth.At(x) - marker->position).norm();
  }
  auto track = std::lower_bound(scene_.tracks.begin(), scene_.tracks.end(), frame, before);
  for (; track != scene_.tracks.end() && track->frame == frame; ++track) {
    const PluckerRay<double>& ray = rays_[track - scene_.tracks.begin()];
    if (!scene_.IsFitted(*track) || ray.direction.isZero()) continue;
    // The length of moment - x x direction is the distance of x from the ray.
    sum += (ray.moment - track->on_cloth.At(x).cross(ray.direction)).norm();
    ++count;
  }
  for (std::size_t i = 0; scene_.clouds && i < scene_.clouds->observations.size(); ++i) {
    const CloudObservation& cloud = scene_.clouds->observations[i];
    if (cloud.frame != frame || !scene_.IsFitted(cloud)) continue;
    for (const PointResidual& r : clouds_.OfPoints(cloud, x)) sum += std::abs(r.value);
    count += static_cast<int>(cloud.points.size());
  }
  constexpr double kMillimetres = 1000.0;
  return count > 0 ? kMillimetres * sum / count : 0.0;
}

double SynthesisError::OfFrame(int frame, const Eigen::VectorXd& x) const {
  if (!scene_.is_fitted[frame]) return 0.0;
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  double error = 0.0;
  if (alpha_ > 0.0) error += alpha_ * static_cast<double>(hard_.FittedDifference(frame, x));
  if (beta_ > 0.0) error += beta_ * MeanAttractor(frame, x);
  return error;
}

}  // namespace clothfit
