// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/small_recording.h"

#include <cmath>
#include <random>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"

namespace clothfit {
namespace {

constexpr double kSize = 0.4;   // m
constexpr double kRate = 30.0;  // Hz

HandleDescription MakeHandle(const char* name, double u, int frames) {
  HandleDescription handle;
  handle.name = name;
  handle.uv = {u, 0.0};
  handle.path_sigma = 1e-4;
  handle.path.emplace();
  for (int frame = 0; frame < frames; ++frame) {
    const double phase = 5.0 * frame / kRate;  // rad
    handle.path->push_back(
        Eigen::Vector3d(u, 0.1 * (1.0 - std::cos(phase)), 1.0 + 0.05 * std::sin(phase)));
  }
  return handle;
}

Recording MakeScenery(const SmallRecordingOptions& options) {
  Recording recording;
  recording.name = "small";
  recording.frame_rate = kRate;
  recording.frame_count = options.frames;
  recording.cloth.size = {kSize, kSize};
  recording.cloth.areal_density = 0.15;
  recording.cloth.resolution = {options.particles, options.particles};
  recording.cloth.initial = FlatPlacement{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  recording.handles = {MakeHandle("left", 0.0, options.frames),
                       MakeHandle("right", kSize, options.frames)};
  recording.noise.marker = options.marker_noise;
  recording.splits.held_out_frames =
      Splits::FrameRange{options.frames - options.frames / 5, options.frames - 1};
  return recording;
}

void AddMarkers(const SmallRecordingOptions& options, const Scene& scene, int frame,
                const State& state, std::mt19937* random, Recording* recording) {
  constexpr int kAlong = 4;
  std::vector<Eigen::Vector2d> uv;
  for (int i = 0; i < kAlong * kAlong; ++i) {
    uv.emplace_back(kSize * (i % kAlong) / (kAlong - 1), kSize * (i / kAlong) / (kAlong - 1));
  }
  const std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  std::normal_distribution<double> normal;
  for (size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3d error;
    for (double& value : error.reverse()) value = normal(*random);
    recording->markers.push_back(
        {frame, static_cast<int>(i), uv[i], points[i].At(state.x) + options.marker_noise * error});
  }
}

}  // namespace

Recording MakeSmallRecording(const SmallRecordingOptions& options) {
  Recording recording = MakeScenery(options);
  FitConfig config = DefaultConfig(recording);
  for (const auto& [name, value] : options.parameters) config.parameters.at(name).value = value;
  const Scene scene = MakeScene(recording, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  std::mt19937 random(1);
  SimulateFrames(scene, config, free, free.start(), options.frames - 1,
                 [&](int frame, const State& state) {
                   AddMarkers(options, scene, frame, state, &random, &recording);
                 });
  return recording;
}

}  // namespace clothfit
