// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/folder.h"

#include <gmock/gmock.h>

#include "fitting/jobs/results.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

JobFolderContents TwoJobs() {
  JobFolderContents contents;
  contents.list = {"study two", nullptr, {{"a", 1}, {"b", 2}}};
  contents.file = "study.json";
  contents.description = "two";
  contents.files = {"two.csv"};
  return contents;
}

class JobFolder : public testing::Test {
 protected:
  fs::path place() const { return test_.path() / "study"; }
  bool Has(const std::string& file) const { return fs::exists(place() / file); }
  void Prepare(Existing existing, const JobFolderContents& contents = TwoJobs()) const {
    PrepareJobFolder(place(), contents, existing);
  }

  TestFolder test_;
};

TEST_F(JobFolder, KeepsResultsWhereItGoesOn) {
  Prepare(Existing::kRefuse);
  EXPECT_EQ(ReadJobList(place()).jobs.size(), 2U);
  WriteJobResult(place() / kResultFolder, {"a", 1, "", 0.0});
  Prepare(Existing::kResume);
  EXPECT_THAT(NamesOfResults(place() / kResultFolder), testing::ElementsAre("a"));
  JobFolderContents others = TwoJobs();
  others.description = "other two";
  EXPECT_THAT(InputErrorOf([&] { Prepare(Existing::kResume, others); }),
              HasSubstr("--resume: the options differ from those in"));
}

TEST_F(JobFolder, IsReplacedWithoutWhatOthersPutThere) {
  Prepare(Existing::kRefuse);
  WriteJobResult(place() / kResultFolder, {"a", 1, "", 0.0});
  test_.Write("study/jobs/mine.json", "mine");
  test_.Write("study/jobs/notes/mine.txt", "mine");
  EXPECT_THAT(InputErrorOf([&] { Prepare(Existing::kRefuse); }),
              HasSubstr("already holds results of a study; --force replaces it, --resume"));
  Prepare(Existing::kReplace);
  EXPECT_FALSE(Has("jobs/a.json"));
  for (const char* file : {"jobs/mine.json", "jobs/notes/mine.txt"}) EXPECT_TRUE(Has(file)) << file;
}

TEST_F(JobFolder, IsReplacedWithWhatSlurmLeft) {
  Prepare(Existing::kRefuse);
  OutputFolder(place() / "slurm", FolderKind::kSlurm, "study two", Existing::kResume).Begin({});
  for (const char* file : {"stage-0.sh", "gather.sh", "submitted.json", "12_7.log", "13.log"})
    test_.Write(std::string("study/slurm/") + file, "Slurm's");
  test_.Write("study/slurm/mine.log", "mine");
  Prepare(Existing::kReplace);
  EXPECT_FALSE(Has("slurm/stage-0.sh"));
  EXPECT_FALSE(Has("slurm/12_7.log"));
  EXPECT_FALSE(Has("slurm/13.log"));
  EXPECT_TRUE(Has("slurm/mine.log"));
}

TEST_F(JobFolder, KeepsASecondCommandOut) {
  const FolderLock lock = PrepareJobFolder(place(), TwoJobs(), Existing::kRefuse);
  EXPECT_THAT(InputErrorOf([&] { Prepare(Existing::kResume); }), HasSubstr("another clothfit"));
  EXPECT_THAT(InputErrorOf([&] { Prepare(Existing::kReplace); }), HasSubstr("another clothfit"));
}

}  // namespace
}  // namespace clothfit
