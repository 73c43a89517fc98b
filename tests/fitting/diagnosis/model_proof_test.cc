// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Proofs on frames before those that are held out.
#include "fitting/diagnosis/model_proof.h"

#include <gtest/gtest.h>

#include "tracking/synthetic_recording.h"

namespace clothfit {
namespace {

Recording ClothInWind() {
  SyntheticOptions options;
  options.size = {0.5, 0.5};
  options.resolution = {5, 5};
  options.markers = {4, 4};
  options.marker_sigma = 0.0005;
  options.frame_rate = 24.0;
  options.frame_count = 30;
  options.parameters = {{"wind.x", 1.5}};
  return WithHeldOutFrames(MakeSyntheticRecording(options).recording, 1.0 / 3.0);
}

class EarlierProof : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording = ClothInWind();
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters) setting.free = false;
    config.parameters.at("stretch.stiffness").free = true;
    before_ = FitAfresh({recording, config}, Start::kPlain, 6, FitRunner());
    ASSERT_TRUE(before_);
    ModelStart with_wind = GoOn(*before_);
    for (const char* name : {"wind.x", "wind.y", "wind.z"})
      with_wind.config.parameters.at(name).free = true;
    std::optional<FittedScene> fitted = FitModel(*before_, with_wind, 8, FitRunner());
    ASSERT_TRUE(fitted);
    errors_ = MeasureHeldOut(*before_);
    model_.errors = MeasureHeldOut(*fitted);
    model_.scene = std::move(*fitted);
  }

  static inline std::optional<FittedScene> before_;
  static inline HeldOutErrors errors_;
  static inline FittedModel model_;
  const Ranking ranking_;
  const DiagnosisOptions options_;
  const ProofStart start_{*before_, errors_, ranking_, options_};
};

TEST_F(EarlierProof, IsOnTheSecondHalfOfWhatWasFitted) {
  const std::optional<HeldOutProof> proof = ProveEarlier(model_, start_);
  ASSERT_TRUE(proof && proof->earlier);
  EXPECT_EQ(proof->earlier->first, 10);
  EXPECT_EQ(proof->earlier->last, 19);
  EXPECT_TRUE(proof->is_proven);
  EXPECT_LT(proof->after, 0.5 * proof->before);
  EXPECT_FALSE(proof->is_in_pixels);
}

TEST_F(EarlierProof, ProvesNothingOfWhatDoesNothing) {
  const FittedModel same{{}, *before_, errors_};
  const std::optional<HeldOutProof> proof = ProveEarlier(same, start_);
  ASSERT_TRUE(proof);
  EXPECT_FALSE(proof->is_proven);
  EXPECT_EQ(proof->before, proof->after);
}

TEST_F(EarlierProof, IsNotAskedForWhereTheHeldOutFramesSpeakAgainstIt) {
  const FittedModel without{{}, *before_, errors_};
  EXPECT_FALSE(ProveEarlier(without, {model_.scene, model_.errors, ranking_, options_}));
}

TEST_F(EarlierProof, NeedsHeldOutFramesAtTheEnd) {
  FittedModel in_the_middle = model_;
  in_the_middle.scene.scene.recording.splits.held_out_frames = {10, 20};
  EXPECT_FALSE(ProveEarlier(in_the_middle, start_));
  in_the_middle.scene.scene.recording.splits.held_out_frames.reset();
  EXPECT_FALSE(ProveEarlier(in_the_middle, start_));
}

TEST_F(EarlierProof, ErrorsCanBeMeasuredUpToAFrame) {
  const HeldOutErrors all = MeasureHeldOut(*before_);
  const HeldOutErrors some = MeasureHeldOut(*before_, {}, 24);
  ASSERT_EQ(all.squared.size(), 10u);
  ASSERT_EQ(some.squared.size(), 5u);
  EXPECT_TRUE(some.is_complete);
  for (std::size_t i = 0; i < some.squared.size(); ++i) EXPECT_EQ(some.squared[i], all.squared[i]);
}

}  // namespace
}  // namespace clothfit
