// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the scheduler of jobs costs: jobs of nothing, and jobs that take a tenth of a second of
// nobody's processor, by several processes.
#include <chrono>
#include <filesystem>
#include <thread>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fitting/jobs/run_jobs.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::vector<Job> Jobs(int count) {
  std::vector<Job> jobs;
  for (int i = 0; i < count; ++i) jobs.push_back({fmt::format("job-{:04}", i), i});
  return jobs;
}

JobRunOptions InNewFolder() {
  JobRunOptions options;
  options.folder = fs::temp_directory_path() / fmt::format("clothfit-jobs-{}", getpid());
  fs::remove_all(options.folder);
  return options;
}

void EmptyJobs(benchmark::State& state) {
  constexpr int kCount = 200;
  const JobRunOptions options = InNewFolder();
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) {
    fs::remove_all(options.folder);
    RunJobs(
        Jobs(kCount), [](const Job& job, const JobContext&) { return job.input; }, options);
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  state.counters["ms_a_job"] = spent.count() / kCount / static_cast<double>(state.iterations());
  fs::remove_all(options.folder);
}
BENCHMARK(EmptyJobs)->Unit(benchmark::kMillisecond)->UseRealTime();

void DoSleepingJobs(int count, const JobRunOptions& options) {
  RunJobs(
      Jobs(count),
      [](const Job& job, const JobContext&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        return job.input;
      },
      options);
}

// Efficiency is work / (time * processes).
void SleepingJobs(benchmark::State& state) {
  constexpr int kCount = 40;
  const auto processes = static_cast<int>(state.range(0));
  const JobRunOptions options = InNewFolder();
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) {
    fs::remove_all(options.folder);
    for (int i = 1; i < processes; ++i) {
      if (fork() == 0) {
        DoSleepingJobs(kCount, options);
        _exit(0);
      }
    }
    DoSleepingJobs(kCount, options);
    while (wait(nullptr) > 0) continue;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  state.counters["efficiency"] =
      0.1 * kCount * static_cast<double>(state.iterations()) / (seconds * processes);
  fs::remove_all(options.folder);
}
BENCHMARK(SleepingJobs)->Arg(1)->Arg(2)->Arg(8)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace clothfit
