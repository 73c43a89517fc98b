// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that begin from several materials.
#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/fit/other_starts.h"
#include "fitting/fit/search.h"
#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

Recording SmallRecording() {
  SyntheticOptions options = DemoRecording();
  options.resolution = {5, 5};
  options.frame_count = 30;
  return MakeSyntheticRecording(options).recording;
}

// So heavily damped that it hardly moves: a start that fits do not get away from.
FitConfig FarAway(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (const char* name : {"stretch.damping", "shear.damping", "bending.damping"})
    config.parameters.at(name).value = 0.5 * config.parameters.at(name).upper;
  config.max_iterations = 8;
  return config;
}

TEST(OtherStarts, ChangeWhatIsFreeWithinItsBounds) {
  FitConfig config = DefaultConfig(SmallRecording());
  config.parameters.at("shear.damping").free = false;
  config.parameters.at("stretch.damping").lower =
      0.9 * config.parameters.at("stretch.damping").value;
  const std::vector<FitConfig> starts = OtherStarts(config);
  ASSERT_EQ(starts.size(), 3U);
  for (const FitConfig& start : starts) {
    const auto ratio = [&](const char* name) {
      return start.parameters.at(name).value / config.parameters.at(name).value;
    };
    EXPECT_DOUBLE_EQ(ratio("shear.damping"), 1.0);
    EXPECT_DOUBLE_EQ(ratio("stretch.damping"), 0.9);
    EXPECT_NEAR(ratio("bending.damping"), 0.1, 1e-12);
    EXPECT_DOUBLE_EQ(ratio("air_drag.normal"), 1.0);
  }
  const auto value = [&](int i, const char* name) { return starts[i].parameters.at(name).value; };
  EXPECT_GT(value(1, "bending.stiffness"), 10.0 * value(0, "bending.stiffness"));
  EXPECT_LT(value(2, "stretch.stiffness"), 0.2 * value(0, "stretch.stiffness"));
}

TEST(OtherStarts, Differ) {
  const auto starts_with_fixed = [](const std::vector<const char*>& names) {
    FitConfig config = DefaultConfig(SmallRecording());
    for (const char* name : names) config.parameters.at(name).free = false;
    const std::vector<FitConfig> starts = OtherStarts(config);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      EXPECT_FALSE(ConfigDifferences(starts[i], config).empty());
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(ConfigDifferences(starts[i], starts[k]).empty());
    }
    return starts.size();
  };
  EXPECT_EQ(starts_with_fixed({}), 3U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness"}), 2U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness", "stretch.stiffness"}), 1U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness", "stretch.stiffness", "stretch.damping",
                               "shear.damping", "bending.damping"}),
            0U);
}

TEST(StagedFit, BeginsFromOthersWhereOneLeavesMoreThanNoise) {
  const Recording recording = SmallRecording();
  const FitConfig config = FarAway(recording);
  const Scene scene = MakeScene(recording, config);
  const FitResult plain = RunFit(scene, config);
  EXPECT_EQ(plain.starts.begun, 1);
  EXPECT_FALSE(plain.misfit);
  const FitResult fit = FitByStrategy(scene, config);
  EXPECT_EQ(fit.starts.begun, 1 + static_cast<int>(OtherStarts(config).size()));
  EXPECT_GE(fit.starts.finished, fit.starts.agreeing);
  EXPECT_LE(fit.cost_after, plain.cost_after);
  EXPECT_GT(fit.simulated_frames, plain.simulated_frames);
  ASSERT_TRUE(fit.misfit);
  EXPECT_EQ(fit.misfit->observed, 3 * 25 * (scene.last_fitted_frame + 1));
}

TEST(StagedFit, IsSatisfiedWithOneStartThatExplainsAll) {
  const Recording recording = SmallRecording();
  const FitConfig config = DefaultConfig(recording);
  const FitResult fit = FitByStrategy(MakeScene(recording, config), config);
  ASSERT_TRUE(fit.misfit);
  EXPECT_TRUE(fit.misfit->IsNoise()) << fit.misfit->chi_square;
  EXPECT_EQ(fit.starts.begun, 1);
}

TEST(StagedFit, DoesAsItIsTold) {
  const Recording recording = SmallRecording();
  FitConfig config = FarAway(recording);
  config.other_starts = false;
  EXPECT_EQ(FitByStrategy(MakeScene(recording, config), config).starts.begun, 1);
}

TEST(StagedFit, DoesNotDependOnTheNumberOfThreads) {
  const Recording recording = SmallRecording();
  FitConfig config = FarAway(recording);
  config.coarse_resolution = 3;
  const Scene scene = MakeScene(recording, config);
  const FitResult many = FitByStrategy(scene, config);
  const InsideParallelWork one_thread;
  const FitResult one = FitByStrategy(scene, config);
  EXPECT_EQ(many.theta, one.theta);
  EXPECT_EQ(many.cost_after, one.cost_after);
  EXPECT_EQ(many.starts.agreeing, one.starts.agreeing);
}

// Stopped while several are under way it ends with the best of them, and goes on from there.
TEST(StagedFit, StopsWithTheBestSoFarAndGoesOn) {
  const Recording recording = SmallRecording();
  const FitConfig config = FarAway(recording);
  const Scene scene = MakeScene(recording, config);
  std::atomic<bool> stop = false;
  FitCheckpoint last;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.checkpoint = [&](const FitCheckpoint& checkpoint) { last = checkpoint; };
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.stage.find("other starts") != std::string::npos && progress.iteration >= 2)
      stop = true;
  };
  const FitResult stopped = FitByStrategy(scene, config, callbacks);
  EXPECT_EQ(stopped.status, FitStatus::kInterrupted);
  EXPECT_EQ(last.theta, stopped.theta);
  stop = false;
  callbacks.progress = {};
  const FitResult resumed = FitByStrategy(scene, config, callbacks, &last);
  EXPECT_LE(resumed.cost_after, stopped.cost_after);
  EXPECT_EQ(resumed.starts.begun, 1);
}

TEST(StagedFit, CallsNothingConvergedThatNothingMoves) {
  const Recording recording = SmallRecording();
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = name == "ground.friction";
  config.initial_order = -1;
  const FitResult fit = FitByStrategy(MakeScene(recording, config), config);
  EXPECT_EQ(fit.status, FitStatus::kNotConverged);
  EXPECT_THAT(fit.statements, testing::Contains(testing::HasSubstr("moves what was observed")));
}

}  // namespace
}  // namespace clothfit
