// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/results.h"

#include <chrono>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "autodiff_sim/base/error.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

TEST(JobResults, KeepTheFirst) {
  const TestFolder folder;
  EXPECT_FALSE(ReadJobResult(folder.path(), "a"));
  WriteJobResult(folder.path(), {"a", 0.1, "", 2.5});
  WriteJobResult(folder.path(), {"a", 7.0, "", 3.5});
  const std::optional<JobResult> read = ReadJobResult(folder.path(), "a");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->output.get<double>(), 0.1);
  EXPECT_EQ(read->seconds, 2.5);
  EXPECT_TRUE(read->IsDone());
}

TEST(JobResults, NameTheFileThatIsNone) {
  const TestFolder folder;
  folder.Write("b.json", "{}");
  EXPECT_THAT(InputErrorOf([&] { ReadJobResult(folder.path(), "b"); }),
              testing::HasSubstr("b.json: no result of a job"));
}

TEST(JobResults, ComeInTheListsOrder) {
  const TestFolder folder;
  EXPECT_TRUE(NamesOfResults(folder.path() / "none").empty());
  for (const char* name : {"a", "b", "c"}) WriteJobResult(folder.path(), {name, name, "", 0.0});
  folder.Write(".d.json.k2x90b.part", "");
  EXPECT_THAT(NamesOfResults(folder.path()), testing::ElementsAre("a", "b", "c"));
  const std::vector<JobResult> results =
      ReadJobResults(folder.path(), {{"c", 0}, {"missing", 0}, {"a", 0}});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].output, "c");
  EXPECT_EQ(results[1].output, "a");
}

TEST(JobResults, SayWhatAStageWaitsFor) {
  const TestFolder folder;
  const std::vector<Job> jobs = {{"a", 0, 0}, {"b", 0, 0}, {"c", 0, 1}};
  EXPECT_EQ(WhatStageWaitsFor(folder.path(), jobs, 0), "");
  WriteJobResult(folder.path(), {"a", 1, "", 0.0});
  EXPECT_EQ(WhatStageWaitsFor(folder.path(), jobs, 1), "b has no result yet");
  WriteJobResult(folder.path(), {"b", 1, "broken", 0.0});
  EXPECT_EQ(WhatStageWaitsFor(folder.path(), jobs, 1), "b failed: broken");
}

}  // namespace
}  // namespace clothfit
