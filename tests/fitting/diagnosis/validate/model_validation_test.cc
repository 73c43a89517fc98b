// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Proofs where the held-out frames alone do not do.
#include "fitting/diagnosis/validate/model_validation.h"

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

class WindValidation : public testing::Test {
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
  const ValidationStart start_{*before_, errors_, ranking_, options_};
};

// Where mesh and step do this (m) to a prediction.
Ranking Rough(double held_out_rms) {
  Ranking rough;
  auto errors = std::make_shared<DiscretisationErrors>();
  errors->held_out_rms = held_out_rms;
  rough.errors = errors;
  return rough;
}

class EarlierValidation : public WindValidation {};
class TwinValidation : public WindValidation {};

TEST_F(EarlierValidation, IsOnTheSecondHalfOfWhatWasFitted) {
  const std::optional<HeldOutValidation> validation = ValidateOnEarlier(model_, start_);
  ASSERT_TRUE(validation && validation->earlier);
  EXPECT_EQ(validation->earlier->first, 10);
  EXPECT_EQ(validation->earlier->last, 19);
  EXPECT_TRUE(validation->is_validated);
  EXPECT_LT(validation->after, 0.5 * validation->before);
  EXPECT_FALSE(validation->is_in_pixels);
}

TEST_F(EarlierValidation, ValidatesNothingThatDoesNothing) {
  const FittedModel same{{}, *before_, errors_};
  const std::optional<HeldOutValidation> validation = ValidateOnEarlier(same, start_);
  ASSERT_TRUE(validation);
  EXPECT_FALSE(validation->is_validated);
  EXPECT_EQ(validation->before, validation->after);
}

TEST_F(EarlierValidation, IsHeldToWhatIsGainedByChanceWhereThatIsKnown) {
  const Ranking rough = Rough(1.0);
  const ValidationStart start{*before_, errors_, rough, options_};
  const std::optional<HeldOutValidation> by_all = ValidateOnEarlier(model_, start);
  EXPECT_TRUE(by_all && !by_all->is_validated);
  const std::optional<HeldOutValidation> little = ValidateOnEarlier(model_, start, 0.001);
  EXPECT_TRUE(little && little->is_validated);
  const std::optional<HeldOutValidation> much = ValidateOnEarlier(model_, start, 0.5);
  EXPECT_TRUE(much && !much->is_validated);
}

TEST_F(EarlierValidation, IsNotAskedForWhereTheHeldOutFramesSpeakAgainstIt) {
  const FittedModel without{{}, *before_, errors_};
  EXPECT_FALSE(ValidateOnEarlier(without, {model_.scene, model_.errors, ranking_, options_}));
}

TEST_F(EarlierValidation, NeedsHeldOutFramesAtTheEnd) {
  FittedModel in_the_middle = model_;
  in_the_middle.scene.scene.recording.splits.held_out_frames = {10, 20};
  EXPECT_FALSE(ValidateOnEarlier(in_the_middle, start_));
  in_the_middle.scene.scene.recording.splits.held_out_frames.reset();
  EXPECT_FALSE(ValidateOnEarlier(in_the_middle, start_));
}

TEST_F(EarlierValidation, ErrorsCanBeMeasuredUpToAFrame) {
  const HeldOutErrors all = MeasureHeldOut(*before_);
  const HeldOutErrors some = MeasureHeldOut(*before_, 24);
  ASSERT_EQ(all.squared.size(), 10u);
  ASSERT_EQ(some.squared.size(), 5u);
  EXPECT_TRUE(some.is_complete);
  for (std::size_t i = 0; i < some.squared.size(); ++i) EXPECT_EQ(some.squared[i], all.squared[i]);
}

TEST_F(TwinValidation, HoldsForWhatGainsLittleOnRecordingsWithoutIt) {
  const std::optional<HeldOutValidation> validation = ValidateOnTwins(model_, start_);
  ASSERT_TRUE(validation && validation->gain_of_null);
  EXPECT_TRUE(validation->is_validated);
  EXPECT_LT(*validation->gain_of_null, 0.1);
  EXPECT_EQ(validation->before, errors_.Rms());
  EXPECT_EQ(validation->after, model_.errors.Rms());
}

TEST_F(TwinValidation, DoesNotDependOnWhatMeshAndStepDoToThePrediction) {
  const Ranking rough = Rough(1.0);
  const ValidationStart start{*before_, errors_, rough, options_};
  EXPECT_FALSE(ValidateOnHeldOut(model_, start).is_validated);
  const std::optional<HeldOutValidation> validation = ValidateOnTwins(model_, start);
  EXPECT_TRUE(validation && validation->is_validated);
}

TEST_F(TwinValidation, IsNotAskedForWhereMeshAndStepLeaveMuchMore) {
  Ranking rough;
  rough.residual_rms = 1.2;
  rough.discretisation_rms = 1.9;
  EXPECT_FALSE(ValidateOnTwins(model_, {*before_, errors_, rough, options_}));
  rough.discretisation_rms = 1.3;  // about as much
  EXPECT_TRUE(ValidateOnTwins(model_, {*before_, errors_, rough, options_}));
  Ranking far;
  far.residual_rms = 16.0;  // fits from there compare nothing
  EXPECT_FALSE(ValidateOnTwins(model_, {*before_, errors_, far, options_}));
}

TEST_F(TwinValidation, IsNotAskedForWhereThePredictionDoesNotImprove) {
  const FittedModel same{{}, *before_, errors_};
  EXPECT_FALSE(ValidateOnTwins(same, start_));
  const FittedModel without{{}, *before_, errors_};
  EXPECT_FALSE(ValidateOnTwins(without, {model_.scene, model_.errors, ranking_, options_}));
}

// Wind, fitted to a recording without any, gains what it gains on other such recordings.
TEST_F(TwinValidation, ValidatesNoWindWhereThereIsNone) {
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
  const std::optional<HeldOutValidation> validation =
      ValidateOnTwins(wind, {*before, errors, ranking_, options_});
  EXPECT_FALSE(validation && validation->is_validated);
}

}  // namespace
}  // namespace clothfit
