// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that begin again where more than noise is left.
#include "fitting/fit/two_starts.h"

#include <atomic>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Recording DemoOn(int side, int markers, unsigned seed = 1) {
  SyntheticOptions options = DemoRecording();
  options.seed = seed;
  options.resolution = {side, side};
  options.markers = {markers, markers};
  return MakeSyntheticRecording(options).recording;
}

double Found(const FitResult& fit, const std::string& name) {
  for (const ParameterEstimate& estimate : fit.estimates)
    if (estimate.name == name) return estimate.value;
  return NAN;
}

void ExpectToBeginAt(const FitConfig& config, const FitResult& fit) {
  for (const ParameterEstimate& estimate : fit.estimates) {
    const auto setting = config.parameters.find(estimate.name);
    if (!estimate.free || setting == config.parameters.end()) continue;
    EXPECT_NEAR(estimate.start, setting->second.value, 1e-9 * setting->second.value)
        << estimate.name;
  }
}

// The truth is 0.4 N s/m; from the default start the fit ends in a valley in which stretching is
// damped a hundred times as strongly.
TEST(TwoStarts, LeaveAValleyOfTooMuchDamping) {
  const Recording recording = DemoOn(9, 5);
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const FitResult once = RunFit(scene, config, {}, nullptr, true);
  ASSERT_TRUE(once.misfit && !once.misfit->IsNoise());
  EXPECT_GT(Found(once, "stretch.damping"), 10.0);
  const FitResult twice = FitFromTwoStarts({{"", &scene, &config}}, {});
  EXPECT_LT(twice.cost_after, 0.95 * once.cost_after);
  EXPECT_TRUE(twice.misfit->IsNoise());
  EXPECT_LT(Found(twice, "stretch.damping"), 1.2);
  EXPECT_GT(Found(twice, "stretch.damping"), 0.13);
  EXPECT_THAT(twice.statements, Contains(HasSubstr("begun again with a tenth of the damping")));
  EXPECT_GT(twice.simulated_frames, once.simulated_frames);
  EXPECT_EQ(twice.cost_before, once.cost_before);
  ExpectToBeginAt(config, twice);
}

// Two show more of one cloth than one does, and lead out of that valley: they are begun far off,
// and stopped early.
TEST(TwoStarts, OfSeveralRecordingsLeaveItTogether) {
  const Recording a = DemoOn(9, 5, 1), b = DemoOn(9, 5, 2);
  FitConfig config = DefaultConfig(a);
  config.parameters.at("stretch.damping").value = 60.0;
  config.max_iterations = 1;
  const Scene scene_a = MakeScene(a, config), scene_b = MakeScene(b, config);
  const std::vector<NamedScene> scenes = {{"a", &scene_a, &config}, {"b", &scene_b, &config}};
  const FitResult once = RunJointFit(scenes, {}, nullptr, true);
  ASSERT_TRUE(once.misfit && !once.misfit->IsNoise());
  const FitResult twice = FitFromTwoStarts(scenes, {});
  EXPECT_LT(twice.cost_after, 0.95 * once.cost_after);
  EXPECT_THAT(twice.statements, Contains(HasSubstr("the fit ends elsewhere")));
  EXPECT_GT(twice.simulated_frames, once.simulated_frames);
  EXPECT_EQ(twice.cost_before, once.cost_before);
  ExpectToBeginAt(config, twice);
  ASSERT_EQ(twice.recordings.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(twice.recordings[i].before.marker_rms, once.recordings[i].before.marker_rms);
    ExpectToBeginAt(config, twice.recordings[i]);
  }
}

TEST(TwoStarts, AreOneWhereNoiseIsLeft) {
  const Recording recording = DemoOn(7, 5);
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters)
    if (name != "stretch.stiffness") setting.free = false;
  const Scene truth = MakeScene(recording, config);
  for (const auto& [name, value] : DemoRecording().parameters)
    config.parameters.at(name).value = value;
  const FitResult once = RunFit(truth, config, {}, nullptr, true);
  ASSERT_TRUE(once.misfit && once.misfit->IsNoise());
  config.parameters.at("stretch.damping").free = true;
  const FitResult one = FitFromTwoStarts({{"", &truth, &config}}, {});
  ASSERT_TRUE(one.misfit && one.misfit->IsNoise());
  EXPECT_THAT(one.statements, Not(Contains(HasSubstr("begun again"))));
  EXPECT_EQ(one.simulated_frames, RunFit(truth, config, {}, nullptr, true).simulated_frames);
}

// Side by side or one after the other.
TEST(TwoStarts, GiveTheSameNumbersForAnyNumberOfThreads) {
  const Recording recording = DemoOn(20, 9);
  FitConfig config = DefaultConfig(recording);
  config.max_iterations = 1;
  config.window_resolution = 7;
  const Scene scene = MakeScene(recording, config);
  const FitResult beside = FitFromTwoStarts({{"", &scene, &config}}, {});
  ASSERT_TRUE(beside.misfit && !beside.misfit->IsNoise());
  const InsideParallelWork inside;
  const FitResult after = FitFromTwoStarts({{"", &scene, &config}}, {});
  EXPECT_EQ(beside.theta, after.theta);
  EXPECT_EQ(beside.statements, after.statements);
  EXPECT_EQ(beside.simulated_frames, after.simulated_frames);
}

TEST(TwoStarts, EndAtOnceWhenStopped) {
  const Recording recording = DemoOn(20, 9);
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const std::atomic<bool> stop = true;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  EXPECT_EQ(FitFromTwoStarts({{"", &scene, &config}}, callbacks).status, FitStatus::kInterrupted);
}

}  // namespace
}  // namespace clothfit
