// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C, and going on afterwards.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <ostream>
#include <regex>
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

// However early it comes: it ends the command at once, and nothing is left half done.
TEST(Interrupted, EndsAtAnyMomentWithinTwoSeconds) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  int checked = 0, interrupted = 0;
  for (const int milliseconds : {0, 20, 60, 120, 200, 300, 500, 1000}) {
    RunningCommand command(kFit, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    command.Signal(checked % 2 == 0 ? SIGTERM : SIGINT);
    const auto begin = std::chrono::steady_clock::now();
    const int status = command.Wait().status;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    // Before the program's first instruction the system itself ends it; a quick machine may have
    // finished by the last moments.
    const bool is_interrupted = status == 130 || status == -SIGTERM || status == -SIGINT;
    EXPECT_TRUE(is_interrupted || (status == 0 && milliseconds >= 300)) << status;
    if (is_interrupted) ++interrupted;
    EXPECT_LT(passed.count(), 3.0) << "1.8 s and what a busy machine takes";
    std::error_code ignored;
    fs::remove_all(folder.path() / "run", ignored);
    ++checked;
  }
  EXPECT_EQ(checked, 8);
  EXPECT_GE(interrupted, 5);
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

// All but the time that it took.
json NumbersOf(const TestFolder& folder, const std::string& run) {
  json summary = json::parse(ReadTextFile(folder.path() / run / "summary.json"));
  summary.erase("seconds");
  return summary;
}

// The rows of progress.csv without their last column, the seconds. Not every search tells its way.
std::string ProgressOf(const TestFolder& folder, const std::string& run) {
  const fs::path file = folder.path() / run / "progress.csv";
  if (!fs::exists(file)) return "";
  return std::regex_replace(ReadTextFile(file), std::regex(",[^,\n]*\n"), "\n");
}

void ExpectSameRun(const TestFolder& folder, const std::string& run, const std::string& whole) {
  EXPECT_EQ(NumbersOf(folder, run), NumbersOf(folder, whole));
  EXPECT_EQ(ProgressOf(folder, run), ProgressOf(folder, whole));
  for (const char* file : {"parameters.yaml", "trajectory.npy", "residuals.csv", "config.yaml"})
    EXPECT_EQ(ReadTextFile(folder.path() / run / file), ReadTextFile(folder.path() / whole / file))
        << file;
}

struct KilledFit {
  const char* name;
  std::vector<std::string> options;
};
void PrintTo(const KilledFit& fit, std::ostream* stream) { *stream << fit.name; }

class Killed : public testing::TestWithParam<KilledFit> {};

// Killed again and again, it comes to the bits of the fit that nothing interrupted.
TEST_P(Killed, GoesOnToTheSameBits) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  const auto fit = [&](const std::string& run) {
    std::vector<std::string> words = {"fit", "rec", "-o", run, "--quiet", "--fix", "stretch"};
    words.insert(words.end(), GetParam().options.begin(), GetParam().options.end());
    return words;
  };
  ASSERT_EQ(RunCommand(fit("whole"), folder.path()).status, 0);

  const fs::path checkpoint = folder.path() / "run" / "checkpoint.bin";
  const auto size = [&] {
    std::error_code ignored;
    const auto bytes = fs::file_size(checkpoint, ignored);
    return ignored ? 0 : bytes;
  };
  int kills = 0;
  std::uintmax_t reached = 0;
  for (std::vector<std::string> words = fit("run"); kills < 3;
       words = {"fit", "--resume", "-o", "run", "--quiet"}) {
    RunningCommand command(words, folder.path());
    // After some evaluations more than the last time.
    constexpr std::uintmax_t kSome = 1000;  // bytes
    while (!command.HasEnded() && size() < reached + kSome)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (command.HasEnded()) break;
    command.Signal(SIGKILL);
    command.Wait();
    reached = size();
    ++kills;
  }
  EXPECT_GT(kills, 0);
  const CommandResult last = RunCommand({"fit", "--resume", "-o", "run", "--quiet"}, folder.path());
  ASSERT_TRUE(last.status == 0 || last.err.find("the run is finished") != std::string::npos)
      << last.err;
  ExpectSameRun(folder, "run", "whole");
}

INSTANTIATE_TEST_SUITE_P(
    Optimisers, Killed,
    testing::Values(
        KilledFit{"lm", {"--window", "0.2"}}, KilledFit{"lm_all_frames", {"--window", "0"}},
        KilledFit{"bobyqa", {"--optimiser", "bobyqa", "--max-simulations", "40"}},
        KilledFit{"pattern", {"--optimiser", "pattern", "--max-simulations", "40"}},
        KilledFit{"annealing", {"--optimiser", "annealing", "--max-simulations", "40"}},
        KilledFit{"nelder_mead", {"--optimiser", "nelder-mead", "--max-simulations", "40"}},
        KilledFit{"two_loop",
                  {"--optimiser", "sbplx", "--strategy", "two-loop", "--max-simulations", "40"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Resume, TakesWhatIsWholeOfACheckpoint) {
  const TestFolder folder;
  WriteSmallRecording(folder);
  const std::vector<std::string> less = {"--fix", "stretch", "--fix", "shear", "--quiet"};
  const auto fit = [&](std::vector<std::string> words) {
    words.insert(words.end(), less.begin(), less.end());
    return RunCommand(words, folder.path());
  };
  ASSERT_EQ(fit({"fit", "rec", "-o", "whole", "--max-iterations", "4"}).status, 0);
  ASSERT_EQ(fit({"fit", "rec", "-o", "run", "--max-iterations", "3"}).status, 0);
  std::string bytes = ReadTextFile(folder.path() / "run" / "checkpoint.bin");
  ASSERT_GT(bytes.size(), 1000u);
  bytes[bytes.size() / 2] ^= 1;
  folder.Write("run/checkpoint.bin", bytes);
  const CommandResult resumed = RunCommand(
      {"fit", "--resume", "-o", "run", "--quiet", "--max-iterations", "4"}, folder.path());
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  ExpectSameRun(folder, "run", "whole");
}

}  // namespace
}  // namespace clothfit
