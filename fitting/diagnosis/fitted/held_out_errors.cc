// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/held_out_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/fitted/seen_cloth.h"
#include "fitting/residuals/hard_silhouette.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

double RootOfMean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::sqrt(std::accumulate(values.begin(), values.end(), 0.0) /
                   static_cast<double>(values.size()));
}

struct FrameMean {
  double sum = 0.0;
  int count = 0;
  void Add(double value) {
    sum += value;
    ++count;
  }
};

FrameMean MarkersOf(const Scene& scene, int frame, const Eigen::VectorXd& x) {
  FrameMean mean;
  for (const MarkerObservation& m : scene.markers) {
    if (m.frame == frame) mean.Add((m.on_cloth.At(x) - m.position).squaredNorm());
  }
  return mean;
}

FrameMean TracksOf(const Scene& scene, int frame, const Eigen::VectorXd& x,
                   std::optional<int> only) {
  FrameMean mean;
  for (const TrackObservation& t : scene.tracks) {
    if (t.frame != frame || t.camera != only.value_or(t.camera)) continue;
    const Camera& camera = scene.recording.cameras[t.camera];
    const Eigen::Vector3d p = t.on_cloth.At(x);
    if (IsInFront(camera, p)) mean.Add((ProjectPoint(camera, p) - t.pixel).squaredNorm());
  }
  return mean;
}

// The same scene, in which everything pulls in all frames but what one source saw.
Scene WithoutSource(const FittedScene& fitted, const FitConfig& config, int source) {
  Recording others = fitted.scene.recording;
  others.splits.held_out_frames.reset();
  if (source == kMarkerSource) {
    others.markers.clear();
  } else {
    const auto is_of_source = [&](const Track& track) { return track.camera == source; };
    others.tracks.erase(std::remove_if(others.tracks.begin(), others.tracks.end(), is_of_source),
                        others.tracks.end());
  }
  return MakeScene(others, config);
}

// Where a model has what is seen in the held-out frames: markers, else tracks' pixels; NaN from
// where it fails on.
std::vector<Eigen::VectorXd> Predicted(const FittedScene& fitted) {
  const Scene& scene = fitted.scene;
  const bool has_markers = !scene.markers.empty();
  const Eigen::VectorXd none =
      Eigen::VectorXd::Constant(has_markers ? 3 : 2, std::numeric_limits<double>::quiet_NaN());
  std::vector<Eigen::VectorXd> seen(has_markers ? scene.markers.size() : scene.tracks.size(), none);
  const FreeParameters free(fitted.values, scene, MakeParameterTable());
  const Eigen::VectorXd theta = ThetaOfPass(free, fitted.unknown);
  SimulateFrames(scene, fitted.values, free, theta, scene.recording.frame_count - 1,
                 [&](int frame, const State& state) {
                   for (std::size_t i = 0; has_markers && i < scene.markers.size(); ++i) {
                     if (scene.markers[i].frame == frame)
                       seen[i] = scene.markers[i].on_cloth.At(state.x);
                   }
                   for (std::size_t i = 0; !has_markers && i < scene.tracks.size(); ++i) {
                     const TrackObservation& t = scene.tracks[i];
                     if (t.frame != frame) continue;
                     seen[i] = ProjectPoint(scene.recording.cameras[t.camera],
                                            Eigen::Vector3d(t.on_cloth.At(state.x)));
                   }
                 });
  std::vector<Eigen::VectorXd> held_out;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const int frame = has_markers ? scene.markers[i].frame : scene.tracks[i].frame;
    if (scene.IsHeldOut(frame)) held_out.push_back(seen[i]);
  }
  return held_out;
}

}  // namespace

double HeldOutErrors::Rms() const {
  return is_complete ? RootOfMean(squared) : std::numeric_limits<double>::infinity();
}

HeldOutErrors MeasureHeldOut(const FittedScene& fitted, std::optional<int> last) {
  const Scene& scene = fitted.scene;
  const FreeParameters free(fitted.config, scene, MakeParameterTable());
  const HardSilhouette hard(scene);
  HeldOutErrors errors;
  const bool has_markers = !scene.markers.empty(), has_tracks = !scene.tracks.empty();
  const int to = last.value_or(scene.recording.frame_count - 1);
  const int reached = SimulateFrames(
      scene, fitted.config, free, fitted.fit.theta, to, [&](int frame, const State& state) {
        if (!scene.IsHeldOut(frame)) return;
        FrameMean mean;
        if (has_markers) {
          mean = MarkersOf(scene, frame, state.x);
        } else if (has_tracks) {
          mean = TracksOf(scene, frame, state.x, {});
        } else {
          for (const HardSilhouette::Difference& d : hard.Differences(frame, state.x))
            mean.Add(static_cast<double>(d.pixels) * static_cast<double>(d.pixels));
        }
        if (mean.count > 0) errors.squared.push_back(mean.sum / mean.count);
      });
  errors.is_complete = reached == to + 1 && !errors.squared.empty();
  return errors;
}

std::optional<HeldOutErrors> MeasureAgainstOthers(const FittedScene& fitted, int source) {
  const Scene& scene = fitted.scene;
  FitConfig config = fitted.values;
  config.attract = true;
  config.use_silhouettes = false;
  const Scene others = WithoutSource(fitted, config, source);
  const std::optional<FitConfig> nudged = NudgedConfig(config, others, 1.0);
  if (!nudged) return {};
  config = *nudged;
  const FreeParameters free(config, others, MakeParameterTable());
  const Eigen::VectorXd theta = ThetaOfPass(free, fitted.unknown);
  WindowSimulator simulator(others, config, free, config.attract, nullptr);
  HeldOutErrors errors;
  const auto outcome = simulator.Run(
      simulator.FirstStart(theta), theta, scene.recording.frame_count - 1, false,
      [&](int frame, const State& state, const Sensitivity*) {
        if (!scene.IsHeldOut(frame)) return;
        const Eigen::VectorXd x = MovedToWhatWasSeen(others, frame, state.x);
        const FrameMean mean = source == kMarkerSource ? MarkersOf(scene, frame, x)
                                                       : TracksOf(scene, frame, x, source);
        if (mean.count > 0) errors.squared.push_back(mean.sum / mean.count);
      });
  if (errors.squared.empty()) return {};
  errors.is_complete = outcome == WindowSimulator::Outcome::kComplete;
  return errors;
}

double HeldOutDistance(const FittedScene& a, const FittedScene& b) {
  const std::vector<Eigen::VectorXd> at_a = Predicted(a), at_b = Predicted(b);
  if (at_a.empty() || at_a.size() != at_b.size()) return 0.0;
  FrameMean mean;
  for (std::size_t i = 0; i < at_a.size(); ++i) mean.Add((at_a[i] - at_b[i]).squaredNorm());
  const double rms = std::sqrt(mean.sum / mean.count);
  return std::isfinite(rms) ? rms : std::numeric_limits<double>::infinity();
}

Recording WithHeldOutFrames(const Recording& recording, double share) {
  Recording result = recording;
  if (result.splits.held_out_frames) return result;
  const int first = std::clamp(static_cast<int>(std::lround((1.0 - share) * recording.frame_count)),
                               1, recording.frame_count - 1);
  if (recording.frame_count > 2) result.splits.held_out_frames = {first, recording.frame_count - 1};
  return result;
}

}  // namespace clothfit
