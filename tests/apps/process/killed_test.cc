// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that are killed, or whose checkpoint is damaged, and go on.
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
  WriteRecording(MakeSmallRecording(), folder.path() / "rec");
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
        KilledFit{"direct", {"--optimiser", "direct", "--max-simulations", "40"}},
        KilledFit{"joint",
                  {"--optimiser", "sbplx", "--strategy", "joint", "--max-simulations", "40"}},
        KilledFit{"annealing", {"--optimiser", "annealing", "--max-simulations", "40"}},
        KilledFit{"nelder_mead", {"--optimiser", "nelder-mead", "--max-simulations", "40"}},
        KilledFit{"two_loop",
                  {"--optimiser", "sbplx", "--strategy", "two-loop", "--max-simulations", "40"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Resume, TakesWhatIsWholeOfACheckpoint) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(), folder.path() / "rec");
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
