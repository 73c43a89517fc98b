// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors over fitted and held-out observations.
#include "fitting/fit/evaluation.h"

#include <cmath>

#include "fitting/residuals/cloud_residuals.h"
#include "fitting/residuals/hard_silhouette.h"
#include "fitting/residuals/marker_places.h"

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

// Markers of all frames, until it is known where they best sit on the cloth.
class MarkerDistances {
 public:
  explicit MarkerDistances(const Scene& scene) : scene_(scene), places_(scene, 0) {}

  // Those of a frame, m.
  void Add(int frame, const Eigen::VectorXd& x) {
    std::vector<PointResidual> fitted;
    const bool has_places = scene_.layout_sigma > 0.0;
    for (; next_ < scene_.markers.size() && scene_.markers[next_].frame == frame; ++next_) {
      const MarkerObservation& m = scene_.markers[next_];
      const Eigen::Vector3d off = m.on_cloth.At(x) - m.position;
      seen_.push_back({frame, m.id, off, {}});
      if (!has_places) continue;
      seen_.back().tangents = TangentsAt(m.on_cloth, scene_.mesh, x);
      for (int k = 0; k < 3; ++k) {
        fitted.push_back({off[k] / scene_.marker_sigma, m.on_cloth,
                          Eigen::RowVector3d::Unit(k) / scene_.marker_sigma});
      }
    }
    if (has_places) places_.Add(frame, x, fitted, nullptr);
  }

  void Finish(Mean* fitted, Mean* held_out, std::map<int, Eigen::Vector2d>* shifts) const {
    if (scene_.layout_sigma > 0.0) *shifts = places_.Shifts();
    for (const Seen& seen : seen_) {
      const auto shift = shifts->find(seen.id);
      const Eigen::Vector3d off =
          shift == shifts->end() ? seen.off : seen.off + seen.tangents * shift->second;
      if (scene_.is_fitted[seen.frame]) fitted->Add(off.squaredNorm());
      if (scene_.IsHeldOut(seen.frame)) held_out->Add(off.squaredNorm());
    }
  }

 private:
  struct Seen {
    int frame, id;
    Eigen::Vector3d off;  // m
    Eigen::Matrix<double, 3, 2> tangents;
  };
  const Scene& scene_;
  MarkerPlaces places_;
  std::size_t next_ = 0;
  std::vector<Seen> seen_;
};

}  // namespace

Evaluation EvaluateScene(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                         const Eigen::VectorXd& theta) {
  Mean markers, held_out_markers, tracks, held_out_tracks, clouds, held_out_clouds;
  const HardSilhouette hard(scene);
  Mean silhouettes, held_out_silhouettes;
  const CloudResiduals to_surface(scene, 0.0);
  MarkerDistances distances(scene);
  std::size_t track = 0, cloud = 0;
  Evaluation evaluation;
  evaluation.frames = SimulateFrames(
      scene, config, free, theta, scene.recording.frame_count - 1,
      [&](int frame, const State& state) {
        distances.Add(frame, state.x);
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
  distances.Finish(&markers, &held_out_markers, &evaluation.marker_shifts);
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
