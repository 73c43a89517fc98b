// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/held_out_errors.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/unfitted_scene.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

TEST(HeldOutErrors, FramesAreHeldOutWhereNoneAre) {
  Recording recording;
  recording.frame_count = 90;
  const Recording split = WithHeldOutFrames(recording, 1.0 / 3.0);
  ASSERT_TRUE(split.splits.held_out_frames.has_value());
  EXPECT_EQ(split.splits.held_out_frames->first, 60);
  EXPECT_EQ(split.splits.held_out_frames->last, 89);
  recording.splits.held_out_frames = {80, 85};
  EXPECT_EQ(WithHeldOutFrames(recording, 0.5).splits.held_out_frames->first, 80);
}

// Half of the frames held out.
Recording SeenByTwo(int frames) {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_rate = 30.0;
  options.frame_count = frames;
  options.steps_per_frame = 4;
  options.num_cameras = 2;
  return WithHeldOutFrames(MakeSyntheticRecording(options).recording, 0.5);
}

TEST(HeldOutErrors, ASourceIsMeasuredAgainstAllOthers) {
  Recording recording = SeenByTwo(12);
  ASSERT_FALSE(recording.markers.empty());
  ASSERT_FALSE(recording.tracks.empty());
  const FittedScene right = UnfittedScene(recording);
  Camera& camera = recording.cameras[1];
  camera.camera_from_world_translation.x() += 0.02;
  const FittedScene wrong = UnfittedScene(recording);
  EXPECT_EQ(MeasureHeldOut(wrong).squared, MeasureHeldOut(right).squared);  // markers
  const auto of_right = MeasureAgainstOthers(right, 1), of_wrong = MeasureAgainstOthers(wrong, 1);
  ASSERT_TRUE(of_right && of_wrong);
  EXPECT_TRUE(of_right->is_complete);
  EXPECT_GT(of_wrong->Rms(), of_right->Rms() + 2.0);  // px
  std::set<int> frames;                               // in which that camera sees anything
  for (const TrackObservation& track : right.scene.tracks) {
    if (track.camera == 1 && right.scene.IsHeldOut(track.frame)) frames.insert(track.frame);
  }
  EXPECT_EQ(of_right->squared.size(), frames.size());
}

// The cloth follows the others, so that a wrong model of it tells nothing against a source; an
// open-loop prediction of the same frames is far off.
TEST(HeldOutErrors, AgainstOthersTheModelHardlyMatters) {
  const Recording recording = SeenByTwo(30);
  FittedScene windy = UnfittedScene(recording);
  for (FitConfig* config : {&windy.config, &windy.values})
    config->parameters.at("wind.y").value = 3.0;
  const double open_loop = MeasureHeldOut(windy).Rms();
  const auto markers = MeasureAgainstOthers(windy, kMarkerSource);
  ASSERT_TRUE(markers.has_value());
  EXPECT_LT(markers->Rms(), 0.2 * open_loop);
}

TEST(HeldOutErrors, NothingIsMeasuredAgainstNothing) {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_count = 6;
  Recording recording = WithHeldOutFrames(MakeSyntheticRecording(options).recording, 0.5);
  recording.tracks.clear();
  EXPECT_FALSE(MeasureAgainstOthers(UnfittedScene(recording), kMarkerSource).has_value());
}

}  // namespace
}  // namespace clothfit
