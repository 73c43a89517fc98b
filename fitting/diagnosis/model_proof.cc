// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model_proof.h"

#include <algorithm>
#include <cmath>

namespace clothfit {
namespace {

constexpr double kBlockSeconds = 0.2;  // of the bootstrap
constexpr int kFewestFrames = 8;       // in each half, to be worth it

bool HasTracksOf(const Scene& scene, int camera) {
  return std::any_of(scene.tracks.begin(), scene.tracks.end(),
                     [camera](const TrackObservation& track) { return track.camera == camera; });
}

// The camera by whose tracks alone the model is to be judged.
std::optional<int> OwnCamera(const FittedModel& model, const Ranking& ranking) {
  const Scene& scene = model.scene.scene;
  const std::vector<int>& faults = model.candidate.faults;
  if (faults.empty() || scene.markers.empty()) return {};
  const Fault& fault = ranking.faults[static_cast<std::size_t>(faults.front())];
  if (!ShowsInTracks(fault) || !HasTracksOf(scene, fault.source)) return {};
  return fault.source;
}

HeldOutProof ProveBy(const HeldOutErrors& before, const HeldOutErrors& after, bool is_in_pixels,
                     const FittedModel& model, const ProofStart& start) {
  const Scene& scene = model.scene.scene;
  const double noise =
      is_in_pixels ? scene.track_sigma * std::sqrt(2.0) : scene.marker_sigma * std::sqrt(3.0);
  // What mesh and step do to a prediction is held against physics, not against a camera.
  const bool is_physics = model.candidate.faults.empty();
  const double numerical =
      is_physics && start.ranking.errors ? start.ranking.errors->held_out_rms : 0.0;
  const int block = static_cast<int>(std::lround(kBlockSeconds * scene.recording.frame_rate));
  HeldOutProof proof = Prove(before, after, block, {noise, numerical}, start.options.seed);
  proof.is_in_pixels = is_in_pixels;
  return proof;
}

// The fit to the frames before `first` alone, begun where that of all fitted frames has ended.
std::optional<FittedScene> FitUntil(int first, const FittedScene& fitted,
                                    const DiagnosisOptions& options) {
  ModelStart start = GoOn(fitted);
  start.recording.splits.held_out_frames = {first, start.recording.frame_count - 1};
  return FitModel(fitted, start, kModelIterations, FitRunner(options));
}

}  // namespace

HeldOutProof ProveOnHeldOut(const FittedModel& model, const ProofStart& start) {
  const std::optional<int> camera = OwnCamera(model, start.ranking);
  const bool is_in_pixels = model.scene.scene.markers.empty() || camera;
  if (!camera) return ProveBy(start.errors, model.errors, is_in_pixels, model, start);
  return ProveBy(MeasureHeldOut(start.before, camera), MeasureHeldOut(model.scene, camera),
                 is_in_pixels, model, start);
}

std::optional<HeldOutProof> ProveEarlier(const FittedModel& model, const ProofStart& start) {
  const Scene& scene = model.scene.scene;
  const auto& held_out = scene.recording.splits.held_out_frames;
  const bool is_at_end = held_out && held_out->last == scene.recording.frame_count - 1;
  const int last = scene.last_fitted_frame, first = (last + 1) / 2;
  if (!is_at_end || first < kFewestFrames) return {};
  const bool is_in_pixels = scene.markers.empty();
  const HeldOutProof worse = ProveBy(model.errors, start.errors, is_in_pixels, model, start);
  if (worse.improvement_lower95 > 0.0) return {};
  const std::optional<FittedScene> before = FitUntil(first, start.before, start.options);
  const std::optional<FittedScene> after = FitUntil(first, model.scene, start.options);
  if (!before || !after) return {};
  HeldOutProof proof = ProveBy(MeasureHeldOut(*before, {}, last), MeasureHeldOut(*after, {}, last),
                               is_in_pixels, model, start);
  proof.earlier = Splits::FrameRange{first, last};
  return proof;
}

}  // namespace clothfit
