// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that choose their mesh, of recordings whose truth has a finer one or the same.
#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/files/evaluation_journal.h"
#include "fitting/fit/search.h"
#include "fitting/runs/fit_run.h"
#include "fitting/studies/recovery_study.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// The recording tells a fit to use 7 x 7 particles; its truth has `refinement` times as many cells.
Recording SwungCloth(int refinement) {
  SyntheticOptions options = DemoRecording();
  options.resolution = {7, 7};
  options.refinement = refinement;
  options.markers = {7, 7};
  options.marker_sigma = 0.001;
  options.frame_count = 24;
  return MakeSyntheticRecording(options).recording;
}

FitConfig ConfigOf(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  config.finest = 13;
  return config;
}

FitOnMesh FitTo(const Recording& recording, const FitConfig& config,
                const FitCallbacks& callbacks = {}) {
  return FitOnChosenMesh(MakeScene(recording, config), config, callbacks);
}

TEST(ChosenMesh, IsFinerWhereResidualsHoldTheErrorOfTheRecordings) {
  const Recording recording = SwungCloth(4);
  FitConfig config = ConfigOf(recording);
  const FitOnMesh fit = FitTo(recording, config);
  ASSERT_TRUE(fit.scene);
  EXPECT_TRUE(fit.config.refined);
  EXPECT_EQ(fit.config.resolution, fit.scene->mesh.grid);
  EXPECT_GT(fit.scene->mesh.grid[0], 7);
  EXPECT_LE(fit.scene->mesh.grid[0], 13);
  EXPECT_THAT(fit.result.statements, testing::Contains(HasSubstr("refined from 7 x 7 to ")));
  config.finest = 0;
  const FitOnMesh kept = FitTo(recording, config);
  ASSERT_TRUE(fit.result.misfit && kept.result.misfit);
  EXPECT_LT(fit.result.misfit->chi_square - 1.0, 0.5 * (kept.result.misfit->chi_square - 1.0));
  EXPECT_GT(fit.result.simulated_frames, kept.result.simulated_frames);
  EXPECT_EQ(fit.result.before.marker_rms, kept.result.before.marker_rms);
}

TEST(ChosenMesh, IsTheRecordingsWhereTheTruthHasIt) {
  const Recording recording = SwungCloth(1);
  const FitOnMesh fit = FitTo(recording, ConfigOf(recording));
  EXPECT_FALSE(fit.scene);
  EXPECT_EQ(fit.config.resolution, (std::array<int, 2>{0, 0}));
}

TEST(ChosenMesh, IsTheOneThatIsGiven) {
  const Recording recording = SwungCloth(4);
  FitConfig config = ConfigOf(recording);
  config.resolution = {7, 7};
  EXPECT_FALSE(FitTo(recording, config).scene);
}

TEST(ChosenMesh, IsKnownToTheRunAndChosenAnewByTheNextFit) {
  const TestFolder folder;
  WriteRecording(SwungCloth(4), folder.path() / "rec");
  const Recording recording = ReadRecording(folder.path() / "rec");
  FitConfig config = ConfigOf(recording);
  config.recording = (folder.path() / "rec").string();
  const RunFolder run(folder.path() / "run", RunFolder::Existing::kRefuse);
  const FitOnMesh fit = FitIntoRun(MakeScene(recording, config), config, run, {}, false);
  ASSERT_TRUE(fit.scene);
  FitConfig of_run = DefaultConfig(recording);
  ReadConfig(run.ConfigFile(), &of_run);
  EXPECT_EQ(of_run.resolution, fit.scene->mesh.grid);
  EXPECT_TRUE(of_run.refined);
  EXPECT_NO_THROW(RequireSameConfig(run, recording, config));
  ForgetChosenMesh(&of_run);
  EXPECT_EQ(of_run.resolution, config.resolution);
}

TEST(ChosenMesh, IsTheSameAfterAnInterruption) {
  const Recording recording = SwungCloth(4);
  const FitConfig config = ConfigOf(recording);
  const TestFolder folder;
  std::atomic<bool> stop = false;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.stage.find("particles, ") != std::string::npos && progress.iteration >= 1)
      stop = true;
  };
  EvaluationJournal first(folder.path() / "journal");
  callbacks.journal = &first;
  const FitOnMesh stopped = FitTo(recording, config, callbacks);
  EXPECT_EQ(stopped.result.status, FitStatus::kInterrupted);
  const FitOnMesh first_mesh = [&] {
    FitConfig kept = config;
    kept.finest = 0;
    return FitTo(recording, kept);
  }();
  ASSERT_TRUE(stopped.result.misfit && first_mesh.result.misfit);
  EXPECT_LE(stopped.result.misfit->chi_square, first_mesh.result.misfit->chi_square);
  stop = false;
  callbacks.progress = {};
  EvaluationJournal second(folder.path() / "journal");
  callbacks.journal = &second;
  const FitOnMesh resumed = FitTo(recording, config, callbacks), at_once = FitTo(recording, config);
  EXPECT_GT(second.num_recalled(), 4);
  ASSERT_TRUE(resumed.scene && at_once.scene);
  EXPECT_EQ(resumed.scene->mesh.grid, at_once.scene->mesh.grid);
  EXPECT_EQ(resumed.result.theta, at_once.result.theta);
  EXPECT_EQ(resumed.result.cost_after, at_once.result.cost_after);
  EXPECT_EQ(resumed.result.iterations, at_once.result.iterations);
}

// What is done stays between 0 and 1 and never goes back.
TEST(ChosenMesh, TellsItsProgressOverAllMeshes) {
  const Recording recording = SwungCloth(4);
  FitCallbacks callbacks;
  double done = 0.0;
  callbacks.progress = [&](const FitProgress& progress) {
    EXPECT_GE(progress.fraction, done - 1e-12);
    EXPECT_LE(progress.fraction, 1.0 + 1e-12);
    done = std::max(done, progress.fraction);
  };
  FitTo(recording, ConfigOf(recording), callbacks);
  EXPECT_GT(done, 0.5);
}

}  // namespace
}  // namespace clothfit
