// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a fit of several recordings.
#include "fitting/runs/joint_run.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/prediction.h"
#include "tests/support/small_recording.h"
#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Existing = RunFolder::Existing;
using testing::HasSubstr;

// Two small recordings with other motions: the second is cut shorter and has other noise.
class JointRun : public testing::Test {
 protected:
  void SetUp() override {
    for (const int frames : {16, 12}) {
      SmallRecordingOptions options;
      options.particles = 5;
      options.frames = frames;
      const fs::path path = folder_.path() / std::to_string(frames);
      WriteRecording(MakeSmallRecording(options), path);
      JointRecording one;
      const Recording recording = ReadRecording(path);
      one.name = path.filename();
      one.config = DefaultConfig(recording);
      one.config.window = 0.1;
      one.scene = MakeScene(recording, one.config);
      recordings_.push_back(one);
    }
  }
  RunFolder Folder(const std::string& name, Existing existing) const {
    return RunFolder::OfSeveral(folder_.path() / name, existing, {"16", "12"});
  }
  void HoldOutTheSecond() {
    recordings_[1].config.hold_out = true;
    recordings_[1].scene = MakeScene(recordings_[1].scene.recording, recordings_[1].config);
  }

  TestFolder folder_;
  std::vector<JointRecording> recordings_;
};

TEST_F(JointRun, IsAFolderOfRuns) {
  HoldOutTheSecond();
  const RunFolder run = Folder("run", Existing::kRefuse);
  WriteRecordingList(ListRecordings({folder_.path() / "16"}, {folder_.path() / "12"}), run.path());
  const FitResult fit = FitIntoJointRun(recordings_, run, {}, false);
  ASSERT_EQ(fit.recordings.size(), 2u);
  const auto listed = ReadRecordingList(run.path());
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[0].name, "16");
  EXPECT_TRUE(listed[1].is_held_out);
  EXPECT_EQ(listed[1].path, folder_.path() / "12");
  // Each is a run like any other: what was found is read back, to the bit.
  for (std::size_t i = 0; i < 2; ++i) {
    const RunFolder one = RunFolder::Open(run.path() / RunFolder::PlaceOf(listed[i].name));
    const FittedRun fitted = ReadFittedRun(one);
    EXPECT_EQ(fitted.config.hold_out, i == 1);
    const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
    EXPECT_LT((free.Values(one.ReadParameters(free)) - fit.recordings[0].parameters).norm(), 1e-12);
    EXPECT_TRUE(fs::exists(one.path() / "trajectory.npy"));
  }
  EXPECT_THAT(InputErrorOf([&] { RunFolder::Open(run.path()); }),
              HasSubstr("expected the run of one"));
}

TEST_F(JointRun, HasParametersOfWhatIsFittedFromTheFirstSteps) {
  HoldOutTheSecond();
  const RunFolder run = Folder("run", Existing::kRefuse);
  int steps = 0;
  FitCallbacks callbacks;
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.iteration == 0 || ++steps > 1) return;
    const RunFolder one = RunFolder::Open(run.path() / RunFolder::PlaceOf("16"));
    const FittedRun fitted = ReadFittedRun(one);
    const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
    EXPECT_TRUE(one.ReadParameters(free).allFinite());
    EXPECT_FALSE(fs::exists(run.path() / "summary.json"));
  };
  FitIntoJointRun(recordings_, run, callbacks, false);
  EXPECT_GT(steps, 1);
}

// An interrupt leaves no time for it once the second start is under way.
TEST_F(JointRun, IsWholeBeforeAnotherStartIsTried) {
  HoldOutTheSecond();
  for (JointRecording& one : recordings_) one.scene.marker_sigma *= 0.1;  // more than that is left
  const RunFolder run = Folder("run", Existing::kRefuse);
  int starts = 0;
  FitCallbacks callbacks;
  callbacks.log = [&](const std::string& line) {
    if (line.find("begun again") == std::string::npos) return;
    ++starts;
    EXPECT_TRUE(fs::exists(run.path() / "summary.json"));
    for (const char* name : {"16", "12"}) {
      const fs::path one = run.path() / RunFolder::PlaceOf(name);
      EXPECT_TRUE(fs::exists(one / "trajectory.npy")) << name;
      const std::string log =
          fs::exists(one / "log.txt") ? ReadInputFile(one / "log.txt") : std::string();
      EXPECT_EQ(log.find("status:"), std::string::npos) << name;
    }
  };
  FitIntoJointRun(recordings_, run, callbacks, false);
  EXPECT_EQ(starts, 1);
}

TEST_F(JointRun, TellsInWhichRecordingNothingHoldsTheCloth) {
  Recording falling = recordings_[1].scene.recording;
  falling.handles.clear();
  recordings_[1].config = DefaultConfig(falling);
  recordings_[1].scene.recording = falling;
  HoldOutTheSecond();
  recordings_[0].config.max_iterations = 1;
  FitIntoJointRun(recordings_, Folder("run", Existing::kRefuse), {}, false);
  const auto summary = nlohmann::json::parse(ReadTextFile(folder_.path() / "run/summary.json"));
  EXPECT_EQ(summary.at("recordings").at(0).at("lack_of_support"), "");
  EXPECT_THAT(summary.at("recordings").at(1).at("lack_of_support").get<std::string>(),
              HasSubstr("it falls freely"));
}

TEST_F(JointRun, GoesOnToTheSameBits) {
  const FitResult at_once =
      FitIntoJointRun(recordings_, Folder("at-once", Existing::kRefuse), {}, false);
  std::atomic<bool> stop = false;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.progress = [&](const FitProgress& progress) {
    if (progress.stage.find("all frames") != std::string::npos && progress.iteration >= 1)
      stop = true;
  };
  {
    const FitResult stopped =
        FitIntoJointRun(recordings_, Folder("run", Existing::kRefuse), callbacks, false);
    EXPECT_EQ(stopped.status, FitStatus::kInterrupted);
    EXPECT_TRUE(fs::exists(folder_.path() / "run/recordings/12/summary.json"));
  }
  // A run of one of them is no fit to go on with.
  EXPECT_THAT(
      InputErrorOf([&] { RunFolder(folder_.path() / "run/recordings/12", Existing::kResume); }),
      HasSubstr("is of a fit of several recordings"));
  const FitResult resumed =
      FitIntoJointRun(recordings_, Folder("run", Existing::kResume), {}, true);
  EXPECT_EQ(resumed.theta, at_once.theta);
  EXPECT_EQ(resumed.cost_after, at_once.cost_after);
  EXPECT_EQ(resumed.iterations, at_once.iterations);
  EXPECT_EQ(resumed.simulated_frames, at_once.simulated_frames);
  for (const char* file : {"parameters.yaml", "trajectory.npy", "residuals.csv"}) {
    for (const char* name : {"12", "16"}) {
      EXPECT_EQ(ReadTextFile(folder_.path() / "run" / RunFolder::PlaceOf(name) / file),
                ReadTextFile(folder_.path() / "at-once" / RunFolder::PlaceOf(name) / file));
    }
  }
}

TEST_F(JointRun, ReplacesItsOwnFilesAlone) {
  Folder("run", Existing::kRefuse).OfRecording("16").WriteConfig(recordings_[0].config);
  folder_.Write("run/recordings/12/mine.txt", "keep");
  EXPECT_THAT(InputErrorOf([&] { Folder("run", Existing::kRefuse); }), HasSubstr("--force"));
  const RunFolder again =
      RunFolder::OfSeveral(folder_.path() / "run", Existing::kReplace, {"other"});
  EXPECT_FALSE(fs::exists(folder_.path() / "run/recordings/16"));
  EXPECT_EQ(ReadTextFile(folder_.path() / "run/recordings/12/mine.txt"), "keep");
}

}  // namespace
}  // namespace clothfit
