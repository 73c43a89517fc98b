// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Plans of trials can be looked at, and wrong ones are refused in one line.
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/apps/command.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

CommandResult Trials(std::vector<std::string> words, const TestFolder& folder) {
  words.insert(words.begin(), "trials");
  return RunCommand(words, folder.path());
}

TEST(TrialsCommand, ListsAPlan) {
  const TestFolder folder;
  const CommandResult listed = Trials({"--list", "unlisted", "--only", "vortex"}, folder);
  ASSERT_EQ(listed.status, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("unlisted-vortex-two-corner-swing-markers-small-s1 "));
  EXPECT_THAT(listed.out, HasSubstr("vortex.speed="));
  EXPECT_THAT(listed.out, HasSubstr("12 trials"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TrialsCommand, RunsOneTrialAndKeepsItsDiagnosis) {
  const TestFolder folder;
  const std::string output = (folder.path() / "out").string();
  const std::vector<std::string> one = {"clean",
                                        "--match",
                                        "stiff-four-corner-sag-markers",
                                        "--finite-elements",
                                        "--frames",
                                        "10",
                                        "--resolution",
                                        "4",
                                        "--finest",
                                        "5",
                                        "--keep-diagnoses",
                                        "-o",
                                        output};
  const CommandResult run = Trials(one, folder);
  ASSERT_EQ(run.status, 0) << run.err;
  const std::filesystem::path kept =
      folder.path() / "out" / "diagnoses" / "clean-none-stiff-four-corner-sag-markers-s1";
  EXPECT_TRUE(std::filesystem::exists(kept / "diagnosis.json"));
  EXPECT_TRUE(std::filesystem::exists(kept / "log.txt"));
  const CommandResult again = Trials({"clean", "-o", output}, folder);
  EXPECT_THAT(BadInputLine(again), HasSubstr("already holds results of trials"));
  const CommandResult other = Trials({"clean", "--resume", "-o", output}, folder);
  EXPECT_THAT(BadInputLine(other), HasSubstr("conditions.yaml"));

  // Begun anew, it removes its own results and nothing else.
  const std::vector<std::string> mine = {"out/jobs/mine.json", "out/recordings/mine.txt",
                                         "out/trials.txt"};
  for (const std::string& file : mine) folder.Write(file, "mine");
  std::vector<std::string> forced = one;
  forced.insert(forced.begin(), "trials");
  forced.emplace_back("--force");
  RunningCommand begun(forced, folder.path());
  while (std::filesystem::exists(folder.path() / "out" / "trials.md") && !begun.HasEnded())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  begun.Signal(SIGKILL);
  begun.Wait();
  EXPECT_FALSE(std::filesystem::exists(kept / "diagnosis.json"));
  for (const std::string& file : mine) EXPECT_EQ(ReadTextFile(folder.path() / file), "mine");
  folder.Write("other/trials.csv", "mine");
  for (const char* how : {"--force", "--resume"})
    BadInputLine(Trials({"clean", "-o", (folder.path() / "other").string(), how}, folder));
  EXPECT_EQ(ReadTextFile(folder.path() / "other" / "trials.csv"), "mine");
}

TEST(TrialsCommand, MeasuresHowFarEffectsMoveTheCloth) {
  const TestFolder folder;
  const CommandResult measured = Trials({"--effects", "unlisted", "--only", "vortex", "--frames",
                                         "10", "--resolution", "4", "--same-generator"},
                                        folder);
  ASSERT_EQ(measured.status, 0) << measured.err;
  EXPECT_THAT(measured.out, HasSubstr("| vortex | two-corner-swing | woven |"));
  EXPECT_THAT(measured.out, HasSubstr("| vortex | two-corner-turn | woven |"));
}

TEST(TrialsCommand, SaysInOneLineWhatIsWrong) {
  const TestFolder folder;
  EXPECT_THAT(BadInputLine(Trials({"--list", "lsited"}, folder)), HasSubstr("'listed'"));
  EXPECT_THAT(BadInputLine(Trials({"--list", "listed", "--only", "wimd"}, folder)),
              HasSubstr("'wind'"));
  EXPECT_THAT(BadInputLine(Trials({"--list", "listed", "--match", "wimd"}, folder)),
              HasSubstr("'wimd'"));
  EXPECT_THAT(BadInputLine(Trials({"--list", "listed", "--seeds", "0"}, folder)),
              HasSubstr("--seeds"));
  EXPECT_THAT(BadInputLine(Trials({"--list", "listed", "--threads", "-1"}, folder)),
              HasSubstr("--threads"));
}

}  // namespace
}  // namespace clothfit
