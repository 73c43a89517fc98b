// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/folder.h"

#include <gmock/gmock.h>

#include "fitting/jobs/ledger.h"
#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

constexpr double kPatience = 60.0;  // s, longer than any of these tests

JobFolderContents TwoJobs() {
  JobFolderContents contents;
  contents.command = "study two";
  contents.file = "study.json";
  contents.description = "two";
  contents.jobs = {{"a", nullptr}, {"b", nullptr}};
  contents.files = {"two.csv"};
  return contents;
}

class JobFolder : public testing::Test {
 protected:
  fs::path place() const { return test_.path() / "study"; }
  bool Has(const std::string& file) const { return fs::exists(place() / file); }
  void Prepare(bool force, bool resume, const JobFolderContents& contents = TwoJobs()) const {
    JobFolderOptions options;
    options.force = force;
    options.resume = resume;
    PrepareJobFolder(place(), contents, options);
  }

  TestFolder test_;
};

TEST_F(JobFolder, ForgetsWorkersButNoResults) {
  Prepare(false, false);
  JobLedger ledger(place() / "jobs", kPatience, 0), other(place() / "jobs", kPatience, 1);
  ledger.Record({"a", 1, "", 0.0});
  EXPECT_TRUE(ledger.Take("b"));
  Prepare(false, true);
  EXPECT_TRUE(other.Take("b"));
  EXPECT_TRUE(other.HasResult("a"));
}

TEST_F(JobFolder, IsReplacedWithoutWhatOthersPutThere) {
  Prepare(false, false);
  JobLedger(place() / "jobs", kPatience, 0).Record({"a", 1, "", 0.0});
  test_.Write("study/jobs/mine.json", "mine");
  test_.Write("study/jobs/mine.lost", "mine");
  test_.Write("study/jobs/notes/mine.txt", "mine");
  EXPECT_THAT(InputErrorOf([&] { Prepare(false, false); }),
              HasSubstr("already holds results of a study; --force replaces it, --resume"));
  Prepare(true, false);
  EXPECT_FALSE(Has("jobs/a.json"));
  for (const char* file : {"jobs/mine.json", "jobs/mine.lost", "jobs/notes/mine.txt"})
    EXPECT_TRUE(Has(file)) << file;
}

TEST_F(JobFolder, KnowsThePointsOfASharedSearch) {
  JobFolderContents contents = TwoJobs();
  contents.shares_searches = true;
  Prepare(false, false, contents);
  JobLedger points(place() / "jobs" / "a.search", kPatience, 0);
  points.Record({"point-000001", 1, "", 0.0});
  EXPECT_TRUE(points.Take("point-000002"));
  test_.Write("study/jobs/a.search/mine.json", "mine");
  Prepare(false, true, contents);
  EXPECT_TRUE(Has("jobs/a.search/point-000001.json"));
  EXPECT_FALSE(Has("jobs/a.search/point-000002.lease"));
  Prepare(true, false, contents);
  EXPECT_FALSE(Has("jobs/a.search/point-000001.json"));
  EXPECT_TRUE(Has("jobs/a.search/mine.json"));
}

TEST_F(JobFolder, KeepsASecondCommandOut) {
  JobFolderOptions options;
  const FolderLock lock = PrepareJobFolder(place(), TwoJobs(), options);
  EXPECT_THAT(InputErrorOf([&] { Prepare(false, true); }), HasSubstr("another clothfit"));
  EXPECT_THAT(InputErrorOf([&] { Prepare(true, false); }), HasSubstr("another clothfit"));
}

TEST_F(JobFolder, IsSharedByTheProcessesOfALaunch) {
  JobFolderOptions first, second;
  first.ranks = {0, 2, "launch"};
  second.ranks = {1, 2, "launch"};
  const FolderLock lock = PrepareJobFolder(place(), TwoJobs(), first);
  EXPECT_NO_THROW(PrepareJobFolder(place(), TwoJobs(), second));
  EXPECT_THAT(InputErrorOf([&] { Prepare(false, true); }), HasSubstr("another clothfit"));
}

}  // namespace
}  // namespace clothfit
