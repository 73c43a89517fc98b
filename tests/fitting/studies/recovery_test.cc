// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits recordings whose truth is known. Smaller cloths than in the study, so that all take seconds.
#include <algorithm>
#include <cmath>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;

SyntheticOptions SmallRecording() {
  SyntheticOptions options = DemoRecording();
  options.resolution = {7, 7};
  options.frame_count = 60;
  return options;
}

FitResult Fit(const Recording& recording, const FitConfig& config) {
  return RunFit(MakeScene(recording, config), config);
}

const ParameterEstimate& Find(const FitResult& fit, std::string_view name) {
  const auto found = std::find_if(fit.estimates.begin(), fit.estimates.end(),
                                  [&](const ParameterEstimate& e) { return e.name == name; });
  EXPECT_NE(found, fit.estimates.end()) << name;
  return *found;
}

// Every determined parameter lies within twice its 95 % interval of the truth: about four sigmas,
// which noise passes once in sixteen thousand times.
int ExpectNearTruth(const FitResult& fit, const SyntheticRecording& synthetic) {
  int checked = 0;
  for (const ParameterEstimate& estimate : fit.estimates) {
    const auto truth = synthetic.truth_parameters.find(estimate.name);
    if (!estimate.free || !estimate.determined || truth == synthetic.truth_parameters.end())
      continue;
    const bool is_log = estimate.lower95 > 0.0;
    const double width = is_log ? std::log(estimate.upper95 / estimate.lower95)
                                : estimate.upper95 - estimate.lower95;
    const double off =
        is_log ? std::log(estimate.value / truth->second) : estimate.value - truth->second;
    EXPECT_LT(std::abs(off), width) << estimate.name;
    ++checked;
  }
  return checked;
}

TEST(Coverage, HasWilsonsInterval) {
  // Wilson's interval of 95 out of 100, computed by hand: (0.8883, 0.9785).
  const Coverage coverage{95, 100};
  EXPECT_NEAR(coverage.lower(), 0.8882, 2e-4);
  EXPECT_NEAR(coverage.upper(), 0.9785, 2e-4);
  EXPECT_EQ((Coverage{0, 0}.lower()), 0.0);
  EXPECT_EQ((Coverage{0, 0}.upper()), 1.0);
}

TEST(Recovery, IntervalsHoldTheTruth) {
  RecoveryOptions options;
  options.recording = SmallRecording();
  options.num_seeds = 4;
  const std::vector<RecoveredSeed> seeds = RunRecoveryStudy(options, {});
  for (const RecoveredSeed& seed : seeds) {
    EXPECT_EQ(seed.status, FitStatus::kConverged) << "seed " << seed.seed;
    EXPECT_EQ(seed.parameters.size(), 9u);
    // As good as the noise: sqrt(3) * 2 mm from 3 * 25 * 40 numbers, within four standard errors.
    EXPECT_NEAR(seed.marker_rms, std::sqrt(3.0) * 0.002, 0.00018);
    EXPECT_LT(seed.held_out_rms, 0.0045);
    for (const RecoveredParameter& parameter : seed.parameters) {
      if (parameter.determined) {
        EXPECT_LT(std::abs(parameter.z), 4.0) << parameter.name << ", seed " << seed.seed;
      }
    }
  }
  const Coverage coverage = CountCoverage(seeds);
  EXPECT_GT(coverage.total, 20);  // most are determined
  // Those of one seed miss together, so that four seeds tell no more; `study recovery` measures.
  EXPECT_GE(coverage.share(), 0.8) << RecoveryAsMarkdown(seeds);
}

TEST(Recovery, DoesNotDependOnTheNumberOfThreads) {
  RecoveryOptions options;
  options.recording = SmallRecording();
  options.recording.resolution = {5, 5};
  options.recording.frame_count = 20;
  options.num_seeds = 3;
  options.num_threads = 1;
  const std::string one = RecoveryAsCsv(RunRecoveryStudy(options, {}));
  options.num_threads = 3;
  EXPECT_EQ(one, RecoveryAsCsv(RunRecoveryStudy(options, {})));
}

TEST(Recovery, FindsAHiddenHandlesPath) {
  SyntheticOptions options = SmallRecording();
  options.hidden_handles = {"right"};
  const SyntheticRecording synthetic = MakeSyntheticRecording(options);
  const FitConfig config = DefaultConfig(synthetic.recording);
  const Scene scene = MakeScene(synthetic.recording, config);
  const FitResult fit = RunFit(scene, config);
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  const FreeParameters free(config, scene, MakeParameterTable());
  std::vector<SceneHandle> handles = scene.handles;
  free.ApplyToHandles(fit.theta, &handles);
  const SyntheticMotion truth = MakeSyntheticMotion(options.scenario, options.size,
                                                    (options.frame_count - 1) / options.frame_rate);
  double squares = 0.0, worst = 0.0, travelled = 0.0;
  for (int f = 0; f <= scene.last_fitted_frame; ++f) {
    const Eigen::Vector3d right = truth.handles[1].path(scene.FrameTime(f));
    const double off = (handles[1].path.At(scene.FrameTime(f)) - right).norm();
    squares += off * off;
    worst = std::max(worst, off);
    travelled = std::max(travelled, (right - truth.handles[1].path(0.0)).norm());
  }
  // The nearest marker, 4 cm away each way, is measured to 2 mm in each frame.
  EXPECT_LT(std::sqrt(squares / (scene.last_fitted_frame + 1)), 0.002);
  // Its ends are known from one side only.
  EXPECT_LT(worst, 0.01);
  EXPECT_GT(travelled, 0.03);  // so that standing still would not do
}

TEST(Recovery, WorksFromTracksAlone) {
  SyntheticOptions options = SmallRecording();
  options.num_cameras = 3;
  options.markers = {5, 5};
  SyntheticRecording synthetic = MakeSyntheticRecording(options);
  synthetic.recording.markers.clear();
  const FitResult fit = Fit(synthetic.recording, DefaultConfig(synthetic.recording));
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  ASSERT_TRUE(fit.after.track_rms.has_value());
  EXPECT_FALSE(fit.after.marker_rms.has_value());
  EXPECT_NEAR(*fit.after.track_rms, std::sqrt(2.0) * 0.5, 0.03);
  EXPECT_GT(ExpectNearTruth(fit, synthetic), 5);
}

// Without a force sensor only forces over mass can be seen.
TEST(Recovery, SaysThatMassAndForcesAreKnownAsRatiosOnly) {
  SyntheticOptions options = SmallRecording();
  options.tell_density = false;
  options.parameters["cloth.areal_density"] = 0.2;
  const SyntheticRecording synthetic = MakeSyntheticRecording(options);
  FitConfig config = DefaultConfig(synthetic.recording);
  ParameterSetting& density = config.parameters.at("cloth.areal_density");
  density.free = true;
  config.parameters.at("air_drag.saturation").free = false;  // it is no force
  config.parameters.at("air_drag.saturation").value =
      synthetic.truth_parameters.at("air_drag.saturation");
  // From a tenth off the truth scaled to the density's prior, so that the priors agree on a factor.
  for (auto& [name, setting] : config.parameters) {
    if (!setting.free || name == "cloth.areal_density") continue;
    setting.value = setting.prior = 1.1 * density.prior / 0.2 * synthetic.truth_parameters.at(name);
  }
  const FitResult fit = Fit(synthetic.recording, config);
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  EXPECT_THAT(fit.statements, Contains(testing::AllOf(
                                  HasSubstr("only the ratios of"), HasSubstr("cloth.areal_density"),
                                  HasSubstr("stretch.stiffness"), HasSubstr("air_drag.normal"))));
  // The priors hold the common factor between them: the density stays within a sigma of its own.
  const ParameterEstimate& found = Find(fit, "cloth.areal_density");
  EXPECT_NEAR(found.value / density.prior, 1.0, 0.15);
  const double factor = found.value / 0.2;
  for (const char* name : {"stretch.stiffness", "shear.stiffness", "air_drag.normal"}) {
    const double ratio = Find(fit, name).value / (factor * synthetic.truth_parameters.at(name));
    EXPECT_NEAR(ratio, 1.0, 0.1) << name;
  }
}

}  // namespace
}  // namespace clothfit
