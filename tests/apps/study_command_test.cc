// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Studies as a user runs them: alone, and by several processes of which one is killed.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/apps/command.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

// Seconds: 5 frames, 3 x 3 particles.
std::vector<std::string> TinyStudy(const std::string& output,
                                   const std::string& values = "1,2,3,4,5,6,7") {
  return {"study",         "cameras", "-o",          output, "--experiments", "experiment-1",
          "--frames",      "5",       "--particles", "3",    "--generator",   "5",
          "--picture",     "96",      "--values",    values, "--recordings",  "recordings",
          "--simulations", "6",       "--quiet"};
}

// With mpirun before it; the shell's status.
int RunByThree(const std::vector<std::string>& words, const fs::path& folder) {
  std::string line = "cd '" + folder.string() +
                     "' && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                     "mpirun --oversubscribe --enable-recovery -n 3 '" CLOTHFIT_COMMAND "'";
  for (const std::string& word : words) line += " '" + word + "'";
  return std::system((line + " >out.txt 2>&1").c_str());
}

bool HasMpirun() { return std::system("command -v mpirun >/dev/null 2>&1") == 0; }

// A process that has a job in hand; 0 where there is none within some seconds.
pid_t FindWorker(const fs::path& jobs) {
  for (int i = 0; i < 4000; ++i) {
    std::error_code error;
    for (fs::directory_iterator entry(jobs, error), end; !error && entry != end;
         entry.increment(error)) {
      if (entry->path().extension() != ".lease") continue;
      std::ifstream lease(entry->path());
      std::string host;
      pid_t process = 0;
      if (lease >> host >> process) return process;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return 0;
}

TEST(StudyCommand, GivesTheSameNumbersWhoeverDoesTheWork) {
  const TestFolder folder;
  std::vector<std::string> alone = TinyStudy("alone");
  alone.insert(alone.end(), {"--threads", "1"});
  const CommandResult done = RunCommand(alone, folder.path());
  ASSERT_EQ(done.status, 0) << done.err;
  const std::string table = ReadTextFile(folder.path() / "alone" / "cameras.csv");
  for (const char* file : {"cameras.md", "cameras.svg", "study.json"})
    EXPECT_TRUE(fs::exists(folder.path() / "alone" / file)) << file;
  EXPECT_THAT(BadInputLine(RunCommand(alone, folder.path())), HasSubstr("--force"));

  std::vector<std::string> resumed = TinyStudy("alone");
  fs::remove(folder.path() / "alone" / "jobs" / "experiment-1-3-cameras.json");
  resumed.emplace_back("--resume");
  ASSERT_EQ(RunCommand(resumed, folder.path()).status, 0);
  EXPECT_EQ(ReadTextFile(folder.path() / "alone" / "cameras.csv"), table);

  if (!HasMpirun()) GTEST_SKIP() << "no mpirun";
  int status = -1;
  std::thread three([&] { status = RunByThree(TinyStudy("three"), folder.path()); });
  const pid_t victim = FindWorker(folder.path() / "three" / "jobs");
  if (victim > 0) kill(victim, SIGKILL);
  three.join();
  EXPECT_GT(victim, 0);
  EXPECT_EQ(status, 0) << ReadTextFile(folder.path() / "out.txt");
  EXPECT_EQ(ReadTextFile(folder.path() / "three" / "cameras.csv"), table);
}

TEST(StudyCommand, SearchesTogetherAsOneAlone) {
  if (!HasMpirun()) GTEST_SKIP() << "no mpirun";
  const TestFolder folder;
  const auto study = [](const std::string& output) {
    std::vector<std::string> words = TinyStudy(output, "3");
    words.emplace_back("--share-search");
    return words;
  };
  const CommandResult done = RunCommand(study("alone"), folder.path());
  ASSERT_EQ(done.status, 0) << done.err;
  ASSERT_EQ(RunByThree(study("three"), folder.path()), 0)
      << ReadTextFile(folder.path() / "out.txt");
  EXPECT_EQ(ReadTextFile(folder.path() / "three" / "cameras.csv"),
            ReadTextFile(folder.path() / "alone" / "cameras.csv"));
}

TEST(StudyCommand, SaysInOneLineWhatIsWrong) {
  const TestFolder folder;
  const auto wrong = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = TinyStudy("wrong");
    words.insert(words.end(), more.begin(), more.end());
    return BadInputLine(RunCommand(words, folder.path()));
  };
  EXPECT_THAT(wrong({"--search", "newton/joint"}), HasSubstr("--search: 'newton'"));
  EXPECT_THAT(wrong({"--patience", "0"}), HasSubstr("--patience"));
  EXPECT_THAT(wrong({"--fabric", "bending.stifness"}), HasSubstr("'bending.stiffness'"));
  EXPECT_FALSE(fs::exists(folder.path() / "wrong"));
}

}  // namespace
}  // namespace clothfit
