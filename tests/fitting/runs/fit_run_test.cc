// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit leaves in its run's folder while it goes on, which is all that is left of it where it
// is ended.
#include "fitting/runs/fit_run.h"

#include <atomic>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/studies/recovery_study.h"
#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

class FitRun : public testing::Test {
 protected:
  static Recording MakeRecording() {
    SyntheticOptions options = DemoRecording();
    options.seed = 1;
    options.resolution = {5, 5};
    options.frame_count = 40;
    options.markers = {5, 5};
    return MakeSyntheticRecording(options).recording;
  }
  // Residuals beyond noise, so that it begins again.
  static FitConfig MakeConfig(const Recording& recording) {
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters)
      if (name != "stretch.stiffness" && name != "stretch.damping") setting.free = false;
    config.parameters.at("air_drag.normal").value = 0.0;
    return config;
  }
  bool Has(const std::string& file) const { return exists(run.path() / file); }

  const TestFolder folder;
  const Recording recording = MakeRecording();
  const FitConfig config = MakeConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const RunFolder run{folder.path() / "run", RunFolder::Existing::kRefuse};
};

TEST_F(FitRun, HasParametersFromTheFirstSteps) {
  int steps = 0;
  Eigen::VectorXd found;
  FitCallbacks callbacks;
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.iteration == 0 || ++steps > 1) return;
    found = run.ReadParameters(FreeParameters(config, scene, MakeParameterTable()));
    EXPECT_FALSE(Has("summary.json"));
  };
  FitIntoRun(scene, config, run, callbacks, false);
  ASSERT_GT(steps, 1);
  ASSERT_EQ(found.size(), 2);
  EXPECT_TRUE(found.allFinite());
}

TEST_F(FitRun, KeepsWhatItHadWhileItIsDoneAgain) {
  std::atomic<bool> stop = false;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.progress = [&](const FitProgress& progress) { stop = progress.iteration == 3; };
  EXPECT_EQ(FitIntoRun(scene, config, run, callbacks, false).result.status,
            FitStatus::kInterrupted);
  const std::string kept = ReadTextFile(run.path() / "parameters.yaml");
  stop = false;
  int steps = 0;
  callbacks.progress = [&](const FitProgress&) {
    if (++steps > 3) return;
    EXPECT_EQ(ReadTextFile(run.path() / "parameters.yaml"), kept);
  };
  FitIntoRun(scene, config, run, callbacks, true);
  EXPECT_GT(steps, 3);
  EXPECT_NE(ReadTextFile(run.path() / "parameters.yaml"), kept);
}

TEST_F(FitRun, IsWholeWhileItBeginsAgain) {
  std::string of_first;
  FitCallbacks callbacks;
  callbacks.log = [&](const std::string& line) {
    if (line.find("begun again") == std::string::npos) return;
    for (const char* file : {"config.yaml", "summary.json", "trajectory.npy", "residuals.csv"})
      EXPECT_TRUE(Has(file)) << file;
    EXPECT_TRUE(run.HasCheckpoint());
    of_first = ReadTextFile(run.path() / "parameters.yaml");
  };
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.stage.find("with less damping") == std::string::npos) return;
    EXPECT_EQ(ReadTextFile(run.path() / "parameters.yaml"), of_first);
  };
  const FitOnMesh fit = FitIntoRun(scene, config, run, callbacks, false);
  EXPECT_THAT(of_first, HasSubstr("stretch.damping"));
  EXPECT_THAT(of_first, testing::Not(HasSubstr(".nan")));
  EXPECT_FALSE(fit.result.misfit->IsNoise());
}

}  // namespace
}  // namespace clothfit
