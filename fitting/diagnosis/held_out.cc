// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/held_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "autodiff_sim/parameter_table.h"
#include "fitting/hard_silhouette.h"

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

FrameMean TracksOf(const Scene& scene, int frame, const Eigen::VectorXd& x) {
  FrameMean mean;
  for (const TrackObservation& t : scene.tracks) {
    if (t.frame != frame) continue;
    const Camera& camera = scene.recording.cameras[t.camera];
    const Eigen::Vector3d p = t.on_cloth.At(x);
    if (IsInFront(camera, p)) mean.Add((ProjectPoint(camera, p) - t.pixel).squaredNorm());
  }
  return mean;
}

}  // namespace

double HeldOutErrors::Rms() const {
  return is_complete ? RootOfMean(squared) : std::numeric_limits<double>::infinity();
}

HeldOutErrors MeasureHeldOut(const FittedScene& fitted) {
  const Scene& scene = fitted.scene;
  const FreeParameters free(fitted.config, scene, MakeParameterTable());
  const HardSilhouette hard(scene);
  HeldOutErrors errors;
  const bool has_markers = !scene.markers.empty(), has_tracks = !scene.tracks.empty();
  const int last = scene.recording.frame_count - 1;
  const int reached = SimulateFrames(
      scene, fitted.config, free, fitted.fit.theta, last, [&](int frame, const State& state) {
        if (!scene.IsHeldOut(frame)) return;
        FrameMean mean;
        if (has_markers) {
          mean = MarkersOf(scene, frame, state.x);
        } else if (has_tracks) {
          mean = TracksOf(scene, frame, state.x);
        } else {
          for (const HardSilhouette::Difference& d : hard.Differences(frame, state.x))
            mean.Add(static_cast<double>(d.pixels) * static_cast<double>(d.pixels));
        }
        if (mean.count > 0) errors.squared.push_back(mean.sum / mean.count);
      });
  errors.is_complete = reached == scene.recording.frame_count && !errors.squared.empty();
  return errors;
}

HeldOutProof Prove(const HeldOutErrors& before, const HeldOutErrors& after, int block, double floor,
                   std::uint64_t seed) {
  HeldOutProof proof;
  proof.before = before.Rms();
  proof.after = after.Rms();
  proof.floor = floor;
  if (!before.is_complete || !after.is_complete || before.squared.size() != after.squared.size()) {
    proof.is_proven = after.is_complete && !before.is_complete && !after.squared.empty();
    return proof;
  }
  const auto frames = static_cast<int>(before.squared.size());
  block = std::clamp(block, 1, std::max(1, frames / 4));
  std::mt19937_64 random(seed);
  std::vector<double> improvements;
  constexpr int kResamples = 1000;
  for (int k = 0; k < kResamples; ++k) {
    double sum_before = 0.0, sum_after = 0.0;
    for (int n = 0; n < frames;) {
      const auto first =
          static_cast<int>(random() % static_cast<std::uint64_t>(frames - block + 1));
      for (int i = 0; i < block && n < frames; ++i, ++n) {
        sum_before += before.squared[static_cast<std::size_t>(first + i)];
        sum_after += after.squared[static_cast<std::size_t>(first + i)];
      }
    }
    improvements.push_back(std::sqrt(sum_before / frames) - std::sqrt(sum_after / frames));
  }
  std::sort(improvements.begin(), improvements.end());
  proof.improvement_lower95 = improvements[kResamples / 20];
  constexpr double kWorthHaving = 0.05;  // of the floor
  proof.is_proven = proof.improvement_lower95 > std::max(0.0, kWorthHaving * floor);
  return proof;
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
