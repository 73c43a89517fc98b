// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/seen_cloth.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

constexpr int kFrame = 9;

SyntheticOptions Options() {
  SyntheticOptions options;
  options.resolution = {6, 6};
  options.frame_count = 12;
  options.frame_rate = 60.0;
  options.held_out_share = 0.0;
  options.markers = {6, 6};
  options.marker_sigma = 1e-6;
  options.num_cameras = 3;
  options.track_sigma = 0.01;
  return options;
}

FitConfig ConfigOf(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  config.use_silhouettes = false;
  return config;
}

// Where a simulation with the parameters that the recording was made with has the cloth.
Eigen::VectorXd Simulated(const Scene& scene, const FitConfig& config) {
  const FreeParameters free(config, scene, MakeParameterTable());
  Eigen::VectorXd x;
  SimulateFrames(scene, config, free, free.start(), kFrame, [&](int frame, const State& state) {
    if (frame == kFrame) x = state.x;
  });
  return x;
}

// Some millimetres beside it, smoothly.
Eigen::VectorXd Beside(const Scene& scene, Eigen::VectorXd x) {
  for (std::size_t i = 0; i < scene.mesh.uv.size(); ++i) {
    const Eigen::Vector2d& uv = scene.mesh.uv[i];
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) +=
        Eigen::Vector3d(0.004, -0.006 + 0.01 * uv.x(), 0.02 * uv.x() * uv.y());
  }
  return x;
}

// How far the cloth is from the markers of the frame, m.
double FromMarkers(const Scene& with_markers, const Eigen::VectorXd& x) {
  double sum = 0.0;
  int count = 0;
  for (const MarkerObservation& m : with_markers.markers) {
    if (m.frame != kFrame) continue;
    sum += (m.on_cloth.At(x) - m.position).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

class MovedToWhatWasSeenTest : public ::testing::Test {
 protected:
  Recording recording_ = MakeSyntheticRecording(Options()).recording;
  FitConfig config_ = ConfigOf(recording_);
  Scene scene_ = MakeScene(recording_, config_);
  Eigen::VectorXd beside_ = Beside(scene_, Simulated(scene_, config_));

  // Without what `is_left_out` says.
  template <class IsLeftOut>
  Eigen::VectorXd MovedWithout(const IsLeftOut& is_left_out) {
    Recording recording = recording_;
    const auto leave_out = [&](auto* all) {
      all->erase(std::remove_if(all->begin(), all->end(), is_left_out), all->end());
    };
    leave_out(&recording.markers);
    leave_out(&recording.tracks);
    return MovedToWhatWasSeen(MakeScene(recording, config_), kFrame, beside_);
  }
};

struct IsTrack {
  bool operator()(const Marker&) const { return false; }
  bool operator()(const Track&) const { return true; }
};
struct IsMarker {
  bool operator()(const Marker&) const { return true; }
  bool operator()(const Track&) const { return false; }
};

TEST_F(MovedToWhatWasSeenTest, IsWhereMarkersAre) {
  EXPECT_GT(FromMarkers(scene_, beside_), 0.005);
  EXPECT_LT(FromMarkers(scene_, MovedWithout(IsTrack())), 2e-4);
}

TEST_F(MovedToWhatWasSeenTest, IsWhereTracksOfThreeCamerasAre) {
  EXPECT_LT(FromMarkers(scene_, MovedWithout(IsMarker())), 5e-4);
}

TEST_F(MovedToWhatWasSeenTest, StaysWhereNothingWasSeen) {
  const auto is_of_the_frame = [](const auto& seen) { return seen.frame == kFrame; };
  EXPECT_EQ(MovedWithout(is_of_the_frame), beside_);
}

}  // namespace
}  // namespace clothfit
