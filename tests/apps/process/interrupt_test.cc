// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C, and going on afterwards.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;

// A fit that takes some seconds, in windows, each with a checkpoint.
const std::vector<std::string> kFit = {"fit",      "rec",   "-o",    "run",
                                       "--window", "0.2",   "--fix", "stretch",
                                       "--fix",    "shear", "--set", "bending.stiffness=3e-5"};

void WriteSmallRecording(const TestFolder& folder) {
  SmallRecordingOptions options;
  options.particles = 6;
  options.frames = 30;
  WriteRecording(MakeSmallRecording(options), folder.path() / "rec");
}

// Waits until the file is there; false where the command ends before.
bool WaitFor(const fs::path& file, RunningCommand* command) {
  using namespace std::chrono_literals;
  while (!fs::exists(file)) {
    if (command->HasEnded()) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

json Summary(const TestFolder& folder) {
  return json::parse(ReadTextFile(folder.path() / "run" / "summary.json"));
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, KeepsTheBestSoFarAndResumes) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  RunningCommand command(kFit, folder.path());
  ASSERT_TRUE(WaitFor(folder.path() / "run" / "checkpoint.bin", &command)) << command.Wait().err;
  command.Signal(GetParam());
  const CommandResult result = command.Wait();
  ASSERT_EQ(result.status, 130) << result.err;
  EXPECT_THAT(result.err, HasSubstr("clothfit: interrupted; 'clothfit fit --resume -o run'"));
  EXPECT_EQ(Summary(folder).at("status"), "interrupted");
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "checkpoint.bin"));
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "trajectory.npy"));

  EXPECT_THAT(
      BadInputLine(RunCommand({"fit", "--resume", "-o", "run", "--window", "0.3"}, folder.path())),
      HasSubstr("differ from those of the run: strategy.window (0.2, not 0.3)"));
  EXPECT_EQ(Summary(folder).at("status"), "interrupted");

  const CommandResult resumed = RunCommand({"fit", "--resume", "-o", "run"}, folder.path());
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  const json summary = Summary(folder);
  EXPECT_EQ(summary.at("status"), "converged");
  EXPECT_NEAR(summary.at("parameters").at("air_drag.normal").at("value"), 2.5, 0.05);
  EXPECT_THAT(ReadTextFile(folder.path() / "run" / "log.txt"),
              HasSubstr("resumed from the checkpoint"));
  EXPECT_FALSE(fs::exists(folder.path() / "run" / "checkpoint.bin"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "--resume", "-o", "run"}, folder.path())),
              HasSubstr("the run is finished"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT));

TEST(Terminate, IsTakenAsCtrlCAndTheSecondEndsAtOnce) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  RunningCommand command(kFit, folder.path());
  // The handlers stand before the first line of the log is written by the fit.
  ASSERT_TRUE(WaitFor(folder.path() / "run" / "checkpoint.bin", &command));
  command.Signal(SIGTERM);
  command.Signal(SIGINT);
  EXPECT_EQ(command.Wait().status, 130);
}

// The baseline's fit alone takes seconds.
std::vector<std::string> DiagnoseInto(const std::string& run) {
  return {"diagnose",      "rec", "-o",           run, "--fix",  "stretch", "--fix", "shear",
          "--max-effects", "1",   "--max-models", "1", "--quiet"};
}

TEST(InterruptedDiagnosis, GoesOnToTheSameAnswer) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  const auto read = [&](const std::string& file) { return ReadTextFile(folder.path() / file); };
  ASSERT_EQ(RunCommand(DiagnoseInto("whole"), folder.path()).status, 0);

  RunningCommand command(DiagnoseInto("run"), folder.path());
  const fs::path fits = folder.path() / "run" / "fits";
  ASSERT_TRUE(WaitFor(fits, &command)) << command.Wait().err;
  const auto has_fit = [&] {
    const fs::directory_iterator files(fits);
    return std::any_of(begin(files), end(files), [](const fs::directory_entry& file) {
      return file.path().extension() == ".cbor";
    });
  };
  while (!has_fit()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  command.Signal(SIGINT);
  const CommandResult result = command.Wait();
  ASSERT_EQ(result.status, 130) << result.err;
  EXPECT_THAT(result.err, HasSubstr("clothfit: interrupted; "));
  EXPECT_THAT(BadInputLine(RunCommand(DiagnoseInto("run"), folder.path())),
              HasSubstr("run: holds an unfinished diagnosis"));

  std::vector<std::string> again = DiagnoseInto("run");
  again.push_back("--resume");
  const CommandResult resumed = RunCommand(again, folder.path());
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(read("run/log.txt"), HasSubstr("resumed with "));
  EXPECT_EQ(read("run/config.yaml"), read("whole/config.yaml"));
  EXPECT_EQ(read("run/baseline.npy"), read("whole/baseline.npy"));
  json one = json::parse(read("run/diagnosis.json")),
       other = json::parse(read("whole/diagnosis.json"));
  for (json* diagnosis : {&one, &other}) diagnosis->erase("seconds");
  EXPECT_EQ(one, other);
  EXPECT_THAT(BadInputLine(RunCommand(again, folder.path())),
              HasSubstr("holds a finished diagnosis"));
  // What was fitted is a run, and stands for the diagnosis where a run is asked for.
  EXPECT_EQ(read("run/fit/parameters.yaml"), read("whole/fit/parameters.yaml"));
  EXPECT_EQ(read("run/fit/trajectory.npy"), read("whole/fit/trajectory.npy"));
  folder.Write("points.csv", "frame,u,v\n0,0.1,0.1\n");
  for (const std::string run : {"whole", "whole/fit"}) {
    const std::string predicted = run == "whole" ? "of_diagnosis.csv" : "of_fit.csv";
    const CommandResult predict =
        RunCommand({"predict", run, "--at", "points.csv", "-o", predicted}, folder.path());
    ASSERT_EQ(predict.status, 0) << predict.err;
  }
  EXPECT_EQ(read("of_diagnosis.csv"), read("of_fit.csv"));
}

TEST(Resume, NeedsARun) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "--resume", "-o", "none"}, folder.path())),
              HasSubstr("none: there is no run to resume"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "--resume"}, folder.path())),
              HasSubstr("--resume: expected the run as -o RUN"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "--resume", "-o", "rec"}, folder.path())),
              HasSubstr("rec: is not the folder of a run"));
}

}  // namespace
}  // namespace clothfit
