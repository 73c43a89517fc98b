// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/held_out.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/unfitted_scene.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

HeldOutErrors Errors(double rms, double spread, unsigned seed, int frames = 60) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  HeldOutErrors errors;
  errors.is_complete = true;
  for (int k = 0; k < frames; ++k)
    errors.squared.push_back(std::pow(rms * std::exp(spread * normal(random)), 2));
  return errors;
}

TEST(HeldOut, AClearImprovementIsProven) {
  const HeldOutProof proof =
      Prove(Errors(0.030, 0.1, 1), Errors(0.009, 0.1, 2), 6, {0.008, 0.0}, 1);
  EXPECT_TRUE(proof.is_proven);
  EXPECT_NEAR(proof.before - proof.after, 0.021, 0.002);
  EXPECT_LT(proof.improvement_lower95, proof.before - proof.after);
  EXPECT_GT(proof.improvement_lower95, 0.015);
}

TEST(HeldOut, ChanceIsNoProof) {
  int proven = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    proven +=
        Prove(Errors(0.01, 0.5, 2 * seed), Errors(0.01, 0.5, 2 * seed + 1), 1, {}, 1).is_proven;
  }
  EXPECT_LE(proven, 6);  // 2 are expected of a test at 95 %
}

TEST(HeldOut, AnImprovementFarBelowTheFloorIsNoProof) {
  const HeldOutErrors before = Errors(0.0101, {}, 1), after = Errors(0.0100, 0.0, 1);
  EXPECT_TRUE(Prove(before, after, 6, {}, 1).is_proven);
  EXPECT_FALSE(Prove(before, after, 6, {0.01, 0.0}, 1).is_proven);
}

TEST(HeldOut, AnImprovementBelowTheNumericalFloorIsNoProof) {
  const HeldOutErrors before = Errors(0.010, 0.0, 1),
                      after = Errors(0.008, 0.0, 1);  // 6 mm squared
  EXPECT_TRUE(Prove(before, after, 6, {0.002, 0.005}, 1).is_proven);
  EXPECT_FALSE(Prove(before, after, 6, {0.002, 0.007}, 1).is_proven);
}

TEST(HeldOut, ASimulationThatDoesNotGetThereProvesNothing) {
  HeldOutErrors after = Errors(0.001, {}, 1);
  after.is_complete = false;
  EXPECT_FALSE(Prove(Errors(0.03, 0.0, 1), after, 6, {}, 1).is_proven);
}

TEST(HeldOut, FramesAreHeldOutWhereNoneAre) {
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

TEST(HeldOut, ASourceIsMeasuredAgainstAllOthers) {
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
TEST(HeldOut, AgainstOthersTheModelHardlyMatters) {
  const Recording recording = SeenByTwo(30);
  FittedScene windy = UnfittedScene(recording);
  for (FitConfig* config : {&windy.config, &windy.values})
    config->parameters.at("wind.y").value = 3.0;
  const double open_loop = MeasureHeldOut(windy).Rms();
  const auto markers = MeasureAgainstOthers(windy, kMarkers);
  ASSERT_TRUE(markers.has_value());
  EXPECT_LT(markers->Rms(), 0.2 * open_loop);
}

TEST(HeldOut, NothingIsMeasuredAgainstNothing) {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_count = 6;
  Recording recording = WithHeldOutFrames(MakeSyntheticRecording(options).recording, 0.5);
  recording.tracks.clear();
  EXPECT_FALSE(MeasureAgainstOthers(UnfittedScene(recording), kMarkers).has_value());
}

}  // namespace
}  // namespace clothfit
