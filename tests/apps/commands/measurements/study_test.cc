// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Studies as a user runs them: by threads, and job by job as any engine does.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "tests/apps/command.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

using Words = std::vector<std::string>;

// Seconds: 5 frames, 3 x 3 particles.
Words TinyStudy(const std::string& output, const std::string& values, const Words& more = {}) {
  Words words = {"study",         "cameras", "-o",          output, "--experiments", "experiment-1",
                 "--frames",      "5",       "--particles", "3",    "--generator",   "5",
                 "--picture",     "96",      "--values",    values, "--recordings",  "recordings",
                 "--simulations", "6",       "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class StudyCommand : public testing::Test {
 protected:
  CommandResult Run(const Words& words) const { return RunCommand(words, folder_.path()); }
  std::string Table(const std::string& study) const {
    return ReadTextFile(folder_.path() / study / "cameras.csv");
  }
  bool Has(const std::string& file) const { return fs::exists(folder_.path() / file); }

  TestFolder folder_;
};

TEST_F(StudyCommand, GivesTheSameNumbersWhoeverDoesTheWork) {
  const Words alone = TinyStudy("alone", "1,2,7", {"--threads", "1"});
  const CommandResult done = Run(alone);
  ASSERT_EQ(done.status, 0) << done.err;
  const std::string table = Table("alone");
  for (const char* file : {"cameras.md", "cameras.svg", "study.json", "jobs.json"})
    EXPECT_TRUE(Has(std::string("alone/") + file)) << file;
  EXPECT_THAT(BadInputLine(Run(alone)), HasSubstr("--force"));

  // Gone on with, by the command itself and by `job`.
  const Words resumed = TinyStudy("alone", "1,2,7", {"--resume"});
  for (const Words& words : {resumed, Words{"job", "alone", "--all", "--threads", "2"}}) {
    fs::remove(folder_.path() / "alone" / "jobs" / "experiment-1-2-cameras.json");
    fs::remove(folder_.path() / "alone" / "cameras.csv");
    EXPECT_EQ(Run({"jobs", "alone", "--gather"}).status, 1);  // a result is missing
    EXPECT_FALSE(Has("alone/cameras.csv"));
    const CommandResult more = Run(words);
    ASSERT_EQ(more.status, 0) << more.err;
    EXPECT_EQ(Table("alone"), table);
  }

  // The commands of a list, run by a shell until there are none; the recordings are made anew.
  fs::remove_all(folder_.path() / "recordings");
  const CommandResult prepared = Run(TinyStudy("listed", "1,2,7", {"--prepare"}));
  ASSERT_EQ(prepared.status, 0) << prepared.err;
  EXPECT_THAT(BadInputLine(Run({"job", "listed", "2"})), HasSubstr("too early"));
  std::vector<std::ptrdiff_t> lengths;
  while (lengths.size() < 5) {
    const CommandResult list = Run({"jobs", "listed", "--list"});
    ASSERT_EQ(list.status, 0) << list.err;
    if (list.out.empty()) break;
    lengths.push_back(std::count(list.out.begin(), list.out.end(), '\n'));
    const fs::path script = folder_.Write("list.sh", list.out);
    ASSERT_EQ(std::system(("cd / && sh '" + script.string() + "'").c_str()), 0);
  }
  EXPECT_THAT(lengths, testing::ElementsAre(1, 3));  // the recording, then its fits
  EXPECT_THAT(Run({"status", "listed"}).out, HasSubstr("4 jobs: 4 done"));
  ASSERT_EQ(Run({"jobs", "listed", "--gather"}).status, 0);
  EXPECT_EQ(Table("listed"), table);
}

TEST_F(StudyCommand, SaysWhatToDoNextOfAList) {
  using testing::EndsWith;
  ASSERT_EQ(Run(TinyStudy("list", "1", {"--prepare"})).status, 0);
  EXPECT_THAT(Run({"status", "list"}).out, EndsWith("\nnext: clothfit job list --all\n"));
  EXPECT_EQ(Run({"job", "list", "0"}).out, "next: clothfit status list\n");
  ASSERT_EQ(Run({"job", "list", "1"}).status, 0);
  EXPECT_THAT(Run({"status", "list"}).out, EndsWith("\nnext: clothfit jobs list --gather\n"));
  EXPECT_THAT(Run({"jobs", "list", "--gather"}).out, EndsWith("\nnext: clothfit report list\n"));
}

TEST_F(StudyCommand, SearchesByManyThreadsAsByOne) {
  for (const char* threads : {"1", "3"}) {
    const CommandResult done =
        Run(TinyStudy(threads, "3", {"--threads", threads, "--under-way", "4"}));
    ASSERT_EQ(done.status, 0) << done.err;
  }
  EXPECT_EQ(Table("3"), Table("1"));
}

TEST_F(StudyCommand, ReplacesItsOwnFilesAndNothingElse) {
  const Words study = TinyStudy("out", "1,2", {"--prepare"});
  const Words forced = TinyStudy("out", "1,2", {"--prepare", "--force"});
  const Words mine = {"out/report.html", "out/mine.csv", "out/jobs/mine.json",
                      "recordings/mine.txt"};
  ASSERT_EQ(Run(study).status, 0);
  for (const std::string& file : mine) folder_.Write(file, "mine");
  folder_.Write("out/cameras.csv", "of the study");
  EXPECT_THAT(BadInputLine(Run(study)), HasSubstr("--force"));
  ASSERT_EQ(Run(forced).status, 0);
  EXPECT_FALSE(Has("out/cameras.csv"));
  for (const std::string& file : mine) EXPECT_EQ(ReadTextFile(folder_.path() / file), "mine");

  folder_.Write("other/cameras.csv", "mine");
  for (const char* how : {"--force", "--resume"})
    EXPECT_THAT(BadInputLine(Run(TinyStudy("other", "1,2", {"--prepare", how}))),
                HasSubstr("other: is not the folder of results of a study that clothfit wrote"));
  EXPECT_EQ(ReadTextFile(folder_.path() / "other" / "cameras.csv"), "mine");
}

TEST_F(StudyCommand, SaysInOneLineWhatIsWrong) {
  const auto wrong = [&](const Words& more) {
    return BadInputLine(Run(TinyStudy("wrong", "1,2", more)));
  };
  EXPECT_THAT(wrong({"--search", "newton/joint"}), HasSubstr("--search: 'newton'"));
  EXPECT_THAT(wrong({"--fabric", "bending.stifness"}), HasSubstr("'bending.stiffness'"));
  EXPECT_THAT(wrong({"--under-way", "2", "--search", "lm/joint"}), HasSubstr("--under-way"));
  EXPECT_THAT(wrong({"--slurm", "--array-size", "0"}), HasSubstr("--array-size: 0"));
  EXPECT_THAT(wrong({"--sbatch=--time=1"}), HasSubstr("--slurm"));
  EXPECT_FALSE(Has("wrong"));
  EXPECT_THAT(BadInputLine(Run({"job", "nowhere", "0"})), HasSubstr("nowhere: has no jobs.json"));
  EXPECT_THAT(BadInputLine(Run({"status", "."})), HasSubstr("has no jobs.json"));
  ASSERT_EQ(Run(TinyStudy("right", "1,2", {"--prepare"})).status, 0);
  EXPECT_THAT(BadInputLine(Run({"job", "right", "7"})), HasSubstr("'7': expected a number from 0"));
  EXPECT_THAT(BadInputLine(Run({"job", "right"})), HasSubstr("--all"));
  EXPECT_THAT(BadInputLine(Run({"jobs", "right"})), HasSubstr("--list"));
}

}  // namespace
}  // namespace clothfit
