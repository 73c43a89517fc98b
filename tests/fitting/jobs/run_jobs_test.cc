// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/run_jobs.h"

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using std::chrono::milliseconds;

std::vector<Job> Numbers(int count) {
  std::vector<Job> jobs;
  for (int i = 0; i < count; ++i) jobs.push_back({fmt::format("n{:02}", i), {{"value", i}}});
  return jobs;
}

nlohmann::json Square(const Job& job, const JobContext& context) {
  context.alive();
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
      EXPECT_GE(done, last);
      EXPECT_EQ(total, 20);
      last = done;
    };
    ExpectSquares(RunJobs(Numbers(20), Square, options), 20);
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

TEST(RunJobs, ReplacesAThreadThatHangs) {
  const TestFolder folder;
  // Outlives the test, as a hanging thread does.
  static std::atomic<bool> has_hung = false, release = false;
  JobRunOptions options;
  options.folder = folder.path();
  options.num_threads = 1;
  options.patience = 0.3;  // s; a square takes microseconds
  const JobRunResult run = RunJobs(
      Numbers(4),
      [](const Job& job, const JobContext& context) {
        if (job.name == "n02" && !has_hung.exchange(true)) {
          while (!release) std::this_thread::sleep_for(milliseconds(5));
        }
        return Square(job, context);
      },
      options);
  ExpectSquares(run, 4);
  EXPECT_EQ(run.num_hanging, 1);
  release = true;
  std::this_thread::sleep_for(milliseconds(100));  // it ends while the folder is still there
}

// Another process that does the same list, slowly.
pid_t StartProcess(const TestFolder& folder, int count) {
  const pid_t process = fork();
  if (process != 0) return process;
  JobRunOptions options;
  options.folder = folder.path();
  RunJobs(
      Numbers(count),
      [](const Job& job, const JobContext& context) {
        std::this_thread::sleep_for(milliseconds(50));
        return Square(job, context);
      },
      options);
  _exit(0);
}

void WaitForLease(const TestFolder& folder) {
  for (int i = 0; i < 1000; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      if (entry.path().extension() == ".lease") return;
    }
    std::this_thread::sleep_for(milliseconds(2));
  }
  FAIL() << "nobody took a job";
}

TEST(RunJobs, SurvivesTheDeathOfOtherProcesses) {
  const TestFolder folder;
  const std::vector<pid_t> others = {StartProcess(folder, 12), StartProcess(folder, 12)};
  WaitForLease(folder);
  kill(others[0], SIGKILL);
  int status = 0;
  waitpid(others[0], &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  JobRunOptions options;
  options.folder = folder.path();
  ExpectSquares(RunJobs(Numbers(12), Square, options), 12);
  waitpid(others[1], &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST(RunJobs, SurvivesAProcessThatStopsMoving) {
  const TestFolder folder;
  const pid_t other = StartProcess(folder, 3);
  WaitForLease(folder);
  kill(other, SIGSTOP);
  JobRunOptions options;
  options.folder = folder.path();
  options.patience = 0.3;  // s
  ExpectSquares(RunJobs(Numbers(3), Square, options), 3);
  kill(other, SIGCONT);  // it finds that all is done, and its late result changes nothing
  int status = 0;
  waitpid(other, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  ExpectSquares(RunJobs(Numbers(3), Square, options), 3);
}

}  // namespace
}  // namespace clothfit
