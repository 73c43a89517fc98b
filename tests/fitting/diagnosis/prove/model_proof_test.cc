// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Proofs where the held-out frames alone do not do.
#include "fitting/diagnosis/prove/model_proof.h"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "fitting/diagnosis/gate/null_residuals.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

Recording ClothInWind() {
  SyntheticOptions options;
  options.size = {0.5, 0.5};
  options.resolution = {7, 7};
  options.markers = {4, 4};
  options.marker_sigma = 0.003;
  options.frame_rate = 24.0;
  options.frame_count = 30;
  options.parameters = {{"wind.x", 1.5}};
  return WithHeldOutFrames(MakeSyntheticRecording(options).recording, 1.0 / 3.0);
}

class WindProof : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording = ClothInWind();
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters) setting.free = false;
    config.parameters.at("stretch.stiffness").free = true;
    before_ = FitAfresh({recording, config}, Start::kPlain, 6, FitRunner());
    ASSERT_TRUE(before_);
    ModelStart with_wind = GoOn(*before_);
    model_.candidate.names = {"wind.x", "wind.y", "wind.z"};
    for (const std::string& name : model_.candidate.names)
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

// Where mesh and step do this (m) to a prediction.
Ranking Rough(double held_out_rms) {
  Ranking rough;
  auto errors = std::make_shared<NumericalErrors>();
  errors->held_out_rms = held_out_rms;
  rough.errors = errors;
  return rough;
}

class EarlierProof : public WindProof {};
class ProofAgainstNull : public WindProof {};

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

TEST_F(EarlierProof, IsHeldToWhatIsGainedByChanceWhereThatIsKnown) {
  const Ranking rough = Rough(1.0);
  const ProofStart start{*before_, errors_, rough, options_};
  const std::optional<HeldOutProof> by_all = ProveEarlier(model_, start);
  EXPECT_TRUE(by_all && !by_all->is_proven);
  const std::optional<HeldOutProof> little = ProveEarlier(model_, start, 0.001);
  EXPECT_TRUE(little && little->is_proven);
  const std::optional<HeldOutProof> much = ProveEarlier(model_, start, 0.5);
  EXPECT_TRUE(much && !much->is_proven);
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
  const HeldOutErrors some = MeasureHeldOut(*before_, 24);
  ASSERT_EQ(all.squared.size(), 10u);
  ASSERT_EQ(some.squared.size(), 5u);
  EXPECT_TRUE(some.is_complete);
  for (std::size_t i = 0; i < some.squared.size(); ++i) EXPECT_EQ(some.squared[i], all.squared[i]);
}

TEST_F(ProofAgainstNull, HoldsForWhatGainsLittleOnRecordingsWithoutIt) {
  const std::optional<HeldOutProof> proof = ProveAgainstNull(model_, start_);
  ASSERT_TRUE(proof && proof->gain_of_null);
  EXPECT_TRUE(proof->is_proven);
  EXPECT_LT(*proof->gain_of_null, 0.1);
  EXPECT_EQ(proof->before, errors_.Rms());
  EXPECT_EQ(proof->after, model_.errors.Rms());
}

TEST_F(ProofAgainstNull, DoesNotDependOnWhatMeshAndStepDoToThePrediction) {
  const Ranking rough = Rough(1.0);
  const ProofStart start{*before_, errors_, rough, options_};
  EXPECT_FALSE(ProveOnHeldOut(model_, start).is_proven);
  const std::optional<HeldOutProof> proof = ProveAgainstNull(model_, start);
  EXPECT_TRUE(proof && proof->is_proven);
}

TEST_F(ProofAgainstNull, IsNotAskedForWhereMeshAndStepLeaveMuchMore) {
  Ranking rough;
  rough.residual_rms = 1.2;
  rough.floor_rms = 1.9;
  EXPECT_FALSE(ProveAgainstNull(model_, {*before_, errors_, rough, options_}));
  rough.floor_rms = 1.3;  // about as much
  EXPECT_TRUE(ProveAgainstNull(model_, {*before_, errors_, rough, options_}));
  Ranking far;
  far.residual_rms = 16.0;  // fits from there compare nothing
  EXPECT_FALSE(ProveAgainstNull(model_, {*before_, errors_, far, options_}));
}

TEST_F(ProofAgainstNull, IsNotAskedForWhereThePredictionDoesNotImprove) {
  const FittedModel same{{}, *before_, errors_};
  EXPECT_FALSE(ProveAgainstNull(same, start_));
  const FittedModel without{{}, *before_, errors_};
  EXPECT_FALSE(ProveAgainstNull(without, {model_.scene, model_.errors, ranking_, options_}));
}

// Wind, fitted to a recording without any, gains what it gains on other such recordings.
TEST_F(ProofAgainstNull, ProvesNoWindWhereThereIsNone) {
  ModelStart calm = GoOn(*before_);
  std::optional<Recording> twin = TwinRecording(*before_, 7);
  ASSERT_TRUE(twin);
  calm.recording = std::move(*twin);
  const std::optional<FittedScene> before = FitModel(*before_, calm, 12, FitRunner());
  ASSERT_TRUE(before);
  ModelStart with_wind = GoOn(*before);
  for (const std::string& name : model_.candidate.names)
    with_wind.config.parameters.at(name).free = true;
  const std::optional<FittedScene> after = FitModel(*before, with_wind, 12, FitRunner());
  ASSERT_TRUE(after);
  const FittedModel wind{model_.candidate, *after, MeasureHeldOut(*after)};
  const HeldOutErrors errors = MeasureHeldOut(*before);
  const std::optional<HeldOutProof> proof =
      ProveAgainstNull(wind, {*before, errors, ranking_, options_});
  EXPECT_FALSE(proof && proof->is_proven);
}

}  // namespace
}  // namespace clothfit
