// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/run_jobs.h"

#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "autodiff_sim/base/parallel.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

std::vector<Job> Numbers(int count) {
  std::vector<Job> jobs;
  for (int i = 0; i < count; ++i) jobs.push_back({fmt::format("n{:02}", i), {{"value", i}}});
  return jobs;
}

nlohmann::json Square(const Job& job, const JobContext&) {
  const int value = job.input.at("value");
  return value * value;
}

void ExpectSquares(const JobRunResult& run, int count) {
  EXPECT_TRUE(run.complete);
  ASSERT_EQ(static_cast<int>(run.results.size()), count);
  for (int i = 0; i < count; ++i) EXPECT_EQ(run.results[static_cast<std::size_t>(i)].output, i * i);
}

TEST(RunJobs, GivesTheSameForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    const TestFolder folder;
    JobRunOptions options;
    options.folder = folder.path();
    options.num_threads = threads;
    int last = -1;
    options.progress = [&](int done, int total) {
      EXPECT_EQ(done, last + 1);
      EXPECT_EQ(total, 20);
      last = done;
    };
    ExpectSquares(RunJobs(Numbers(20), Square, options), 20);
    EXPECT_EQ(last, 20);
  }
}

TEST(RunJobs, DoesOnlyWhatIsLeft) {
  const TestFolder folder;
  JobRunOptions options;
  options.folder = folder.path();
  RunJobs(Numbers(5), Square, options);
  std::atomic<int> count = 0;
  const JobWork counted = [&](const Job& job, const JobContext& context) {
    ++count;
    return Square(job, context);
  };
  ExpectSquares(RunJobs(Numbers(8), counted, options), 8);
  EXPECT_EQ(count, 3);
}

TEST(RunJobs, TellsOfAFailureAndGoesOn) {
  const TestFolder folder;
  JobRunOptions options;
  options.folder = folder.path();
  const JobRunResult run = RunJobs(
      Numbers(3),
      [](const Job& job, const JobContext& context) -> nlohmann::json {
        if (job.name == "n01") throw std::runtime_error("no such luck");
        return Square(job, context);
      },
      options);
  EXPECT_TRUE(run.complete);
  EXPECT_EQ(run.CountProblems(), 1);
  EXPECT_EQ(run.FirstProblem(), "n01: no such luck");
  EXPECT_EQ(run.results[2].output, 4);
}

TEST(RunJobs, StopsAndGoesOn) {
  const TestFolder folder;
  std::atomic<bool> stop = false;
  JobRunOptions options;
  options.folder = folder.path();
  options.stop = &stop;
  const JobRunResult stopped = RunJobs(
      Numbers(6),
      [&](const Job& job, const JobContext& context) {
        if (job.name == "n03") stop = true;
        return Square(job, context);
      },
      options);
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.results.size(), 3U);  // what was cut short is no result
  stop = false;
  ExpectSquares(RunJobs(Numbers(6), Square, options), 6);
}

TEST(RunJobs, BeginsAStageAfterTheOneBefore) {
  const TestFolder folder;
  JobRunOptions options;
  options.folder = folder.path();
  options.num_threads = 3;
  std::vector<Job> jobs = Numbers(9);
  for (std::size_t i = 4; i < jobs.size(); ++i) jobs[i].stage = 1;
  std::atomic<int> first_done = 0;
  const JobWork work = [&](const Job& job, const JobContext& context) {
    if (job.stage == 1) {
      EXPECT_EQ(first_done, 4) << job.name;
    }
    nlohmann::json square = Square(job, context);
    first_done += job.stage == 0 ? 1 : 0;
    return square;
  };
  ExpectSquares(RunJobs(jobs, work, options), 9);
}

TEST(RunJobs, EndsWithAStageThatFails) {
  const TestFolder folder;
  JobRunOptions options;
  options.folder = folder.path();
  std::vector<Job> jobs = Numbers(3);
  jobs[2].stage = 1;
  const JobRunResult run = RunJobs(
      jobs,
      [](const Job& job, const JobContext& context) -> nlohmann::json {
        if (job.name == "n01") throw std::runtime_error("no such luck");
        return Square(job, context);
      },
      options);
  EXPECT_FALSE(run.complete);
  EXPECT_EQ(run.results.size(), 2U);
  EXPECT_EQ(run.CountProblems(), 1);
}

TEST(RunJobs, SharesTheThreadsAmongJobs) {
  const TestFolder folder;
  JobRunOptions options;
  options.folder = folder.path();
  options.num_threads = 6;
  options.threads_a_job = 4;  // so one at a time
  std::atomic<int> inside = 0;
  const JobWork work = [&](const Job& job, const JobContext& context) {
    EXPECT_EQ(++inside, 1);
    EXPECT_EQ(context.num_threads, 4);
    EXPECT_EQ(NumThreads(0), 1);  // what does not ask has one core
    --inside;
    return Square(job, context);
  };
  ExpectSquares(RunJobs(Numbers(5), work, options), 5);
}

}  // namespace
}  // namespace clothfit
