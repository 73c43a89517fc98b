// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/recording.h"

#include <cmath>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

SyntheticOptions SmallOptions() {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_count = 12;
  options.markers = {3, 2};
  return options;
}

void ExpectSameMarkers(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.markers.size(), b.markers.size());
  ASSERT_FALSE(a.markers.empty());
  for (std::size_t i = 0; i < a.markers.size(); ++i) {
    EXPECT_EQ(a.markers[i].frame, b.markers[i].frame);
    EXPECT_EQ(a.markers[i].uv, b.markers[i].uv);
    EXPECT_EQ(a.markers[i].position, b.markers[i].position);
  }
}

TEST(SyntheticMotion, StartsOnTheClothAndIsTwiceDifferentiable) {
  int checked = 0;
  for (const std::string& name : SyntheticScenarioNames()) {
    const double duration = 2.0, h = 1e-3;
    const SyntheticMotion motion =
        MakeSyntheticMotion(ParseSyntheticScenario("--scenario", name), {0.4, 0.6}, duration);
    for (const SyntheticHandle& handle : motion.handles) {
      const FlatPlacement& flat = motion.initial;
      const Eigen::Vector3d start =
          flat.origin + handle.uv.x() * flat.u_axis + handle.uv.y() * flat.v_axis;
      EXPECT_LT((handle.path(0.0) - start).norm(), 1e-12) << name;
      EXPECT_LT((handle.path(h) - start).norm() / h, 1e-3) << name;  // at rest, m/s
      // A jump of the acceleration would be seen as a difference that h does not shrink.
      const auto acceleration = [&](double t) {
        return Eigen::Vector3d((handle.path(t + h) - 2.0 * handle.path(t) + handle.path(t - h)) /
                               (h * h));
      };
      for (double t = -0.1; t < duration + 0.1; t += h) {
        const double jump = (acceleration(t + h) - acceleration(t)).norm();
        ASSERT_LT(jump, 2500.0 * h) << name << " at " << t;  // jerk, m/s^3
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1000);
}

TEST(SyntheticMotion, SuggestsTheNearestScenario) {
  EXPECT_THAT(InputErrorOf([] { ParseSyntheticScenario("--scenario", "corner-lif"); }),
              HasSubstr("did you mean 'corner-lift'?"));
}

TEST(SyntheticRecording, IsTheSameForTheSameSeedOnly) {
  SyntheticOptions options = SmallOptions();
  const SyntheticRecording first = MakeSyntheticRecording(options);
  const SyntheticRecording second = MakeSyntheticRecording(options);
  ExpectSameMarkers(first.recording, second.recording);
  options.seed = 2;
  const SyntheticRecording third = MakeSyntheticRecording(options);
  EXPECT_NE(first.recording.markers[0].position, third.recording.markers[0].position);
  EXPECT_EQ(first.truth_points[50].position, third.truth_points[50].position);
}

TEST(SyntheticRecording, MarkersLieAroundTheTruthByTheirSigma) {
  SyntheticOptions noisy = SmallOptions(), clean = noisy;
  clean.marker_sigma = 0.0;
  const Recording a = MakeSyntheticRecording(noisy).recording;
  const Recording b = MakeSyntheticRecording(clean).recording;
  EXPECT_FALSE(b.noise.marker.has_value());
  ASSERT_EQ(a.markers.size(), 12u * 6u);
  double squares = 0.0;
  for (std::size_t i = 0; i < a.markers.size(); ++i)
    squares += (a.markers[i].position - b.markers[i].position).squaredNorm();
  const double count = 3.0 * static_cast<double>(a.markers.size());
  // Five standard errors of a standard deviation from n numbers: sigma / sqrt(2 n).
  EXPECT_NEAR(std::sqrt(squares / count), 0.002, 5.0 * 0.002 / std::sqrt(2.0 * count));
}

TEST(SyntheticRecording, TellsMarkersPlacesByTheirSigma) {
  SyntheticOptions rough = SmallOptions(), exact = rough;
  rough.layout_sigma = 0.003;
  const Recording a = MakeSyntheticRecording(rough).recording;
  const Recording b = MakeSyntheticRecording(exact).recording;
  EXPECT_EQ(a.noise.layout, 0.003);
  EXPECT_FALSE(b.noise.layout.has_value());
  ASSERT_EQ(a.markers.size(), b.markers.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < a.markers.size(); ++i) {
    EXPECT_EQ(a.markers[i].position, b.markers[i].position);
    const Marker& first = a.markers[i % 6];
    EXPECT_EQ(a.markers[i].uv, first.uv);  // the same in all frames
    if (i < 6) squares += (first.uv - b.markers[i].uv).squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / 12.0), 0.003, 5.0 * 0.003 / std::sqrt(24.0));
}

TEST(SyntheticRecording, TracksAreTheMarkersSeenByTheCameras) {
  SyntheticOptions options = SmallOptions();
  options.marker_sigma = options.track_sigma = 0.0;
  options.num_cameras = 3;
  const Recording recording = MakeSyntheticRecording(options).recording;
  ASSERT_EQ(recording.cameras.size(), 3u);
  ASSERT_EQ(recording.tracks.size(), 3 * recording.markers.size());  // all are in the pictures
  for (const Track& track : recording.tracks) {
    const Marker& marker = recording.markers[static_cast<std::size_t>(6 * track.frame + track.id)];
    ASSERT_EQ(marker.uv, track.uv);
    const Eigen::Vector2d pixel =
        ProjectPoint(recording.cameras[static_cast<std::size_t>(track.camera)], marker.position);
    // Half a micrometre is about 5e-4 px; the pixel itself is rounded to 1e-3.
    EXPECT_LT((pixel - track.pixel).norm(), 2e-3);
  }
}

TEST(SyntheticRecording, CamerasDoNotChangeTheMarkers) {
  SyntheticOptions options = SmallOptions();
  const Recording without = MakeSyntheticRecording(options).recording;
  options.num_cameras = 2;
  ExpectSameMarkers(without, MakeSyntheticRecording(options).recording);
}

TEST(SyntheticRecording, HidesHandlesAndDensity) {
  SyntheticOptions options = SmallOptions();
  options.hidden_handles = {"right"};
  options.tell_density = false;
  const Recording recording = MakeSyntheticRecording(options).recording;
  ASSERT_EQ(recording.handles.size(), 2u);
  EXPECT_TRUE(recording.handles[0].path.has_value());
  EXPECT_FALSE(recording.handles[1].path.has_value());
  EXPECT_FALSE(recording.cloth.areal_density.has_value());
  options.hidden_handles = {"rigth"};
  EXPECT_THAT(InputErrorOf([&] { MakeSyntheticRecording(options); }),
              HasSubstr("did you mean 'right'?"));
}

TEST(SyntheticRecording, HandlesHoldTheClothOnTheirPaths) {
  SyntheticOptions options = SmallOptions();
  options.truth_points = {2, 2};
  options.frame_count = 40;
  const SyntheticRecording synthetic = MakeSyntheticRecording(options);
  double largest = 0.0;
  for (const TruthPoint& point : synthetic.truth_points) {
    if (point.uv != Eigen::Vector2d::Zero()) continue;
    const Eigen::Vector3d held = *(*synthetic.recording.handles[0].path)[point.frame];
    EXPECT_LT((held - point.position).norm(), 2e-6) << "frame " << point.frame;
    largest = std::max(largest, (held - *(*synthetic.recording.handles[0].path)[0]).norm());
  }
  EXPECT_GT(largest, 0.04);
}

TEST(SyntheticRecording, EveryScenarioStaysAboveItsGround) {
  int checked = 0;
  for (const std::string& name : SyntheticScenarioNames()) {
    SyntheticOptions options = SmallOptions();
    options.scenario = ParseSyntheticScenario("--scenario", name);
    options.frame_count = 30;
    const SyntheticRecording synthetic = MakeSyntheticRecording(options);
    if (!synthetic.recording.ground_height) continue;
    double highest = 0.0;
    for (const TruthPoint& point : synthetic.truth_points) {
      EXPECT_GT(point.position.z(), -1e-3) << name;
      highest = std::max(highest, point.position.z());
      ++checked;
    }
    EXPECT_GT(highest, 0.2) << name;
  }
  EXPECT_GT(checked, 0);
}

TEST(SyntheticRecording, ReadsBackAsWritten) {
  SyntheticOptions options = SmallOptions();
  options.num_cameras = 2;
  options.parameters = {{"air_drag.normal", 0.5}};
  const SyntheticRecording written = MakeSyntheticRecording(options);
  const TestFolder folder;
  for (const auto& [file, contents] : FilesOf(written)) folder.Write(file, contents);
  const Recording read = ReadRecording(folder.path());
  ExpectSameMarkers(written.recording, read);
  EXPECT_EQ(read.tracks.size(), written.recording.tracks.size());
  EXPECT_EQ(read.splits.held_out_frames->first, 8);
  EXPECT_EQ(read.splits.held_out_frames->last, 11);
  EXPECT_EQ(ReadTruthPoints(folder.path()).size(), 12u * 81u);
  EXPECT_EQ(ReadTruthParameters(folder.path()).at("air_drag.normal"), 0.5);
  EXPECT_EQ(ReadTruthParameters(folder.path()), written.truth_parameters);
}

TEST(SyntheticRecording, RefusesUselessOptions) {
  SyntheticOptions options = SmallOptions();
  options.markers = {0, 0};
  EXPECT_THAT(InputErrorOf([&] { options.Check("synthesize"); }), HasSubstr("no camera"));
  options = SmallOptions();
  options.parameters = {{"air_drag.norml", 1.0}};
  EXPECT_THAT(InputErrorOf([&] { options.Check("synthesize"); }),
              HasSubstr("did you mean 'air_drag.normal'?"));
  options.parameters = {{"air_drag.normal", -1.0}};
  EXPECT_THAT(InputErrorOf([&] { options.Check("synthesize"); }),
              HasSubstr("synthesize: parameters: air_drag.normal: -1: expected"));
  options = SmallOptions();
  options.frame_count = 1;
  EXPECT_EQ(InputErrorOf([&] { options.Check("synthesize"); }),
            "synthesize: frames: 1: expected 2 to 1000000");
}

}  // namespace
}  // namespace clothfit
