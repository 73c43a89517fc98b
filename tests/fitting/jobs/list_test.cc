// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/list.h"

#include <gmock/gmock.h>

#include "autodiff_sim/base/error.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

JobList Three() {
  return {"study squares", {{"full", true}}, {{"a", 1, 0}, {"b", {{"x", 0.1}}, 0}, {"c", 3, 1}}};
}

TEST(JobList, IsReadAsItWasWritten) {
  const TestFolder folder;
  folder.Write(kJobListFile, JobListAsText(Three()));
  const JobList read = ReadJobList(folder.path());
  EXPECT_EQ(read.command, "study squares");
  EXPECT_EQ(read.options, Three().options);
  ASSERT_EQ(read.jobs.size(), 3U);
  EXPECT_EQ(read.jobs[1].name, "b");
  EXPECT_EQ(read.jobs[1].input, Three().jobs[1].input);
  EXPECT_EQ(read.jobs[2].stage, 1);
}

TEST(JobList, IsRefusedWhereItIsNoneOrOfAnotherVersion) {
  const TestFolder folder;
  const auto problem = [&] { return InputErrorOf([&] { ReadJobList(folder.path()); }); };
  EXPECT_THAT(problem(), HasSubstr("has no jobs.json"));
  folder.Write(kJobListFile, "{");
  EXPECT_THAT(problem(), HasSubstr("jobs.json: is no list of jobs"));
  nlohmann::json list = nlohmann::json::parse(JobListAsText(Three()));
  list["clothfit"] = "0.0.7";
  folder.Write(kJobListFile, list.dump());
  EXPECT_THAT(problem(), HasSubstr("clothfit: '0.0.7'"));
}

TEST(JobList, IsRefusedWhereANameLeadsElsewhere) {
  const TestFolder folder;
  for (const char* name : {"", ".", "..", "../../a", "/a", "a/b", "a\x1b[2J"}) {
    JobList list = Three();
    list.jobs[1].name = name;
    folder.Write(kJobListFile, JobListAsText(list));
    EXPECT_THAT(InputErrorOf([&] { ReadJobList(folder.path()); }),
                HasSubstr("jobs.json: jobs: name '"))
        << name;
  }
}

TEST(JobRange, IsANumberOrTwo) {
  const JobList list = Three();
  EXPECT_EQ(ParseJobRange("1", list).first, 1);
  EXPECT_EQ(ParseJobRange("1", list).last, 1);
  EXPECT_EQ(ParseJobRange("1-7", list).last, 2);
  for (const char* wrong : {"", "3", "-1", "2-1", "one", "0-", "0-1-2"}) {
    EXPECT_THAT(InputErrorOf([&] { ParseJobRange(wrong, list); }), HasSubstr("from 0 to 2"))
        << wrong;
  }
}

}  // namespace
}  // namespace clothfit
