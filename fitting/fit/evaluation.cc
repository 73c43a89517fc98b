// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors over fitted and held-out observations.
#include "fitting/fit/evaluation.h"

#include <cmath>

#include "fitting/residuals/cloud_residuals.h"
#include "fitting/residuals/hard_silhouette.h"

namespace clothfit {
namespace {

// A root mean square that is empty until something is added.
struct Mean {
  double sum = 0.0;
  int count = 0;
  void Add(double value) {
    sum += value;
    ++count;
  }
  std::optional<double> Value() const {
    if (count == 0) return std::nullopt;
    return sum / count;
  }
  std::optional<double> Root() const {  // of the mean of squares
    if (count == 0) return std::nullopt;
    return std::sqrt(sum / count);
  }
};

}  // namespace

Evaluation EvaluateScene(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                         const Eigen::VectorXd& theta) {
  Mean markers, held_out_markers, tracks, held_out_tracks, clouds, held_out_clouds;
  const HardSilhouette hard(scene);
  Mean silhouettes, held_out_silhouettes;
  const CloudResiduals to_surface(scene, 0.0);
  std::size_t marker = 0, track = 0, cloud = 0;
  Evaluation evaluation;
  evaluation.frames = SimulateFrames(
      scene, config, free, theta, scene.recording.frame_count - 1,
      [&](int frame, const State& state) {
        for (; marker < scene.markers.size() && scene.markers[marker].frame == frame; ++marker) {
          const MarkerObservation& m = scene.markers[marker];
          const double squared = (m.on_cloth.At(state.x) - m.position).squaredNorm();
          if (scene.is_fitted[frame]) markers.Add(squared);
          if (scene.IsHeldOut(frame)) held_out_markers.Add(squared);
        }
        for (; track < scene.tracks.size() && scene.tracks[track].frame == frame; ++track) {
          const TrackObservation& t = scene.tracks[track];
          const Camera& camera = scene.recording.cameras[t.camera];
          const Eigen::Vector3d p = t.on_cloth.At(state.x);
          if (!IsInFront(camera, p)) continue;
          const double squared = (ProjectPoint(camera, p) - t.pixel).squaredNorm();
          if (scene.IsFitted(t))
            tracks.Add(squared);
          else if (scene.IsHeldOut(frame) || scene.is_fitted[frame])
            held_out_tracks.Add(squared);
        }
        for (; scene.clouds && cloud < scene.clouds->observations.size() &&
               scene.clouds->observations[cloud].frame == frame;
             ++cloud) {
          const CloudObservation& seen = scene.clouds->observations[cloud];
          const bool is_compared = scene.IsHeldOut(frame) || scene.is_fitted[frame];
          if (!is_compared) continue;
          for (const PointResidual& r : to_surface.OfPoints(seen, state.x))
            (scene.IsFitted(seen) ? clouds : held_out_clouds).Add(r.value * r.value);
        }
        for (const HardSilhouette::Difference& d : hard.Differences(frame, state.x)) {
          if (scene.IsFitted(frame, d.camera))
            silhouettes.Add(static_cast<double>(d.pixels));
          else if (scene.IsHeldOut(frame) || scene.is_fitted[frame])
            held_out_silhouettes.Add(static_cast<double>(d.pixels));
        }
      });
  evaluation.complete = evaluation.frames == scene.recording.frame_count;
  evaluation.marker_rms = markers.Root();
  evaluation.track_rms = tracks.Root();
  evaluation.cloud_rms = clouds.Root();
  evaluation.silhouette_error = silhouettes.Value();
  // Open loop to the last frame or not at all: a part of the held-out frames would flatter.
  if (evaluation.complete) {
    evaluation.held_out_marker_rms = held_out_markers.Root();
    evaluation.held_out_track_rms = held_out_tracks.Root();
    evaluation.held_out_cloud_rms = held_out_clouds.Root();
    evaluation.held_out_silhouette_error = held_out_silhouettes.Value();
  }
  return evaluation;
}

}  // namespace clothfit
