// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/validate/model_validation.h"

#include <gtest/gtest.h>

#include "fitting/diagnosis/fitted/refit.h"
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
    for (const char* name : {"wind.x", "wind.y", "wind.z"})
      with_wind.config.parameters.at(name).free = true;
    model_ = FitModel(*before_, with_wind, 8, FitRunner());
    ASSERT_TRUE(model_);
  }

  static inline std::optional<FittedScene> before_, model_;
};

TEST_F(WindValidation, IsThatOfAPredictionOfTheHeldOutFrames) {
  const HeldOutValidation validation = ValidateOnHeldOut(*model_, *before_, {}, 0.0, 1);
  EXPECT_TRUE(validation.is_validated);
  EXPECT_LT(validation.after, 0.5 * validation.before);
  EXPECT_FALSE(validation.is_in_pixels);
  EXPECT_FALSE(validation.is_against_others);
}

TEST_F(WindValidation, ValidatesNothingThatDoesNothing) {
  const HeldOutValidation validation = ValidateOnHeldOut(*before_, *before_, {}, 0.0, 1);
  EXPECT_FALSE(validation.is_validated);
  EXPECT_EQ(validation.before, validation.after);
}

TEST_F(WindValidation, IsHeldToWhatMeshAndStepDoToAPrediction) {
  EXPECT_FALSE(ValidateOnHeldOut(*model_, *before_, {}, 1.0, 1).is_validated);
}

TEST(FaultySource, IsTheCameraOrTheMarkers) {
  Ranking ranking;
  ranking.faults = {{Fault::Kind::kMarkerClock, "markers: clock", "clock", "s"},
                    {Fault::Kind::kCameraTurn, "camera 1: pose", "turn", "rad", 1}};
  RankedCandidate candidate;
  EXPECT_FALSE(FaultySource(candidate, ranking));
  candidate.faults = {0};
  EXPECT_EQ(FaultySource(candidate, ranking), kMarkerSource);
  candidate.faults = {1};
  EXPECT_EQ(FaultySource(candidate, ranking), 1);
}

}  // namespace
}  // namespace clothfit
