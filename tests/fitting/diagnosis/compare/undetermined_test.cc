// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/undetermined.h"

#include <gtest/gtest.h>

#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

TEST(Undetermined, AreComponentsThatMayBeNothing) {
  const std::vector<EffectParameter> wind = {{"wind.x", "m/s", -0.4, -1.5, 0.8},
                                             {"wind.y", "m/s", 0.26, 0.2, 0.3},
                                             {"wind.z", "m/s", 0.2, -1.2, 1.5}};
  EXPECT_EQ(Undetermined(wind), (std::vector<std::string>{"wind.x", "wind.z"}));
}

TEST(Undetermined, LeavesTheOneThatIsKnownBest) {
  const std::vector<EffectParameter> wind = {{"wind.x", "m/s", -0.4, -1.5, 0.8},
                                             {"wind.y", "m/s", 0.2, -0.01, 0.3}};
  EXPECT_EQ(Undetermined(wind), std::vector<std::string>{"wind.x"});
}

TEST(Undetermined, AreNoPlacesNorWhatIsAlone) {
  const std::vector<EffectParameter> patch = {{"heavy_patch.share", "1", 0.5, 0.0, 1.0},
                                              {"heavy_patch.u", "m", 0.0, 0.0, 0.1}};
  EXPECT_TRUE(Undetermined(patch).empty());
}

TEST(Undetermined, ValuesAreTheModelsAndInIntervals) {
  FitConfig values;
  values.parameters["wind.x"].value = 0.0;
  values.parameters["wind.y"].value = 0.31;
  std::vector<EffectParameter> wind = {{"wind.x", "m/s", -0.4, -1.5, 0.8},
                                       {"wind.y", "m/s", 0.26, 0.2, 0.3}};
  TakeValues(values, &wind);
  EXPECT_EQ(wind[0].value, 0.0);
  EXPECT_EQ(wind[0].lower90, -1.5);
  EXPECT_EQ(wind[1].value, 0.31);
  EXPECT_NEAR(wind[1].lower90, 0.2 * 0.31 / 0.26, 1e-12);  // as wide as they were, around it
  EXPECT_NEAR(wind[1].upper90, 0.3 * 0.31 / 0.26, 1e-12);
  values.parameters["wind.y"].value = -0.02;
  TakeValues(values, &wind);
  EXPECT_NEAR(wind[1].upper90 - wind[1].lower90, 0.1 * 0.31 / 0.26, 1e-12);
}

// Which need not be 0.
TEST(Undetermined, WhatWasTakenOutIsAtItsOffValue) {
  FitConfig values;
  values.parameters["stretch_orthotropy.ratio"].value = 1.0;
  std::vector<EffectParameter> found = {{"stretch_orthotropy.ratio", "1", 1.5, 1.2, 2.0}};
  TakeValues(values, &found);
  EXPECT_EQ(found[0].value, 1.0);
  EXPECT_EQ(found[0].lower90, 1.0);
  EXPECT_EQ(found[0].upper90, 2.0);
}

// A cloth in wind, which is fitted with a component too many and with one too few.
class UndeterminedWind : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording = MakeSmallRecording({5, 24, 0.001, {{"wind.y", kWind}}});
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters) setting.free = name == "stretch.stiffness";
    before_ = FitAfresh({recording, config}, Start::kPlain, 1, FitRunner());
    for (const char* name : {"wind.y", "wind.z"}) config.parameters.at(name).free = true;
    std::optional<FittedScene> scene =
        FitAfresh({recording, config}, Start::kPlain, 8, FitRunner());
    ASSERT_TRUE(before_ && scene);
    HeldOutErrors errors = MeasureHeldOut(*scene);
    model_.emplace(FittedModel{{}, std::move(*scene), std::move(errors)});
  }

  static constexpr double kWind = 1.0;  // m/s
  static inline std::optional<FittedScene> before_;
  static inline std::optional<FittedModel> model_;
};

TEST_F(UndeterminedWind, IsTakenOut) {
  const std::optional<FittedModel> simpler = WithoutUndetermined(
      *model_, before_->fit.cost_after,
      {{"wind.y", "m/s", 1.0, 0.9, 1.1}, {"wind.z", "m/s", 0.1, -1.0, 1.0}}, FitRunner());
  ASSERT_TRUE(simpler);
  EXPECT_EQ(simpler->scene.values.parameters.at("wind.z").value, 0.0);
  EXPECT_FALSE(simpler->scene.config.parameters.at("wind.z").free);
  EXPECT_NEAR(simpler->scene.values.parameters.at("wind.y").value, kWind, 0.1);
}

// An interval that holds nothing by mistake.
TEST_F(UndeterminedWind, StaysWhereTheModelIsWorseWithout) {
  EXPECT_FALSE(WithoutUndetermined(
      *model_, before_->fit.cost_after,
      {{"wind.y", "m/s", 1.0, -0.9, 9.0}, {"wind.z", "m/s", 0.1, 0.0, 0.1}}, FitRunner()));
}

}  // namespace
}  // namespace clothfit
