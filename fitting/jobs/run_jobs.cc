// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/run_jobs.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>

#include "autodiff_sim/base/parallel.h"
#include "fitting/jobs/results.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

JobResult DoJob(const Job& job, const JobWork& work, const JobContext& context) {
  const InsideParallelWork inside;  // a job has the cores that its context says
  const auto start = std::chrono::steady_clock::now();
  JobResult result;
  result.name = job.name;
  try {
    result.output = work(job, context);
  } catch (const std::exception& error) {
    result.problem = error.what();
    if (result.problem.empty()) result.problem = "failed";
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

// One call at a time, of several threads.
class Progress {
 public:
  Progress(const JobRunOptions& options, int done, int total)
      : options_(options), done_(done), total_(total) {
    Tell(0);
  }
  void Tell(int more) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += more;
    if (options_.progress) options_.progress(done_, total_);
  }

 private:
  const JobRunOptions& options_;
  std::mutex mutex_;
  int done_, total_;
};

void RunStage(const std::vector<const Job*>& open, const JobWork& work,
              const JobRunOptions& options, Progress* progress) {
  const int cores = NumThreads(options.num_threads);
  const int at_once = std::max(1, cores / std::max(1, options.threads_a_job));
  const JobContext context{options.stop, std::min(cores, std::max(1, options.threads_a_job))};
  const auto is_stopped = [&] { return options.stop != nullptr && *options.stop; };
  ParallelFor(static_cast<int>(open.size()), at_once, [&](int piece, int) {
    if (is_stopped()) return;
    const JobResult result = DoJob(*open[static_cast<std::size_t>(piece)], work, context);
    if (is_stopped()) return;
    WriteJobResult(options.folder, result);
    progress->Tell(1);
  });
}

}  // namespace

std::string JobRunResult::FirstProblem() const {
  for (const JobResult& result : results) {
    if (!result.IsDone()) return result.name + ": " + result.problem;
  }
  return "";
}

int JobRunResult::CountProblems() const {
  return static_cast<int>(std::count_if(results.begin(), results.end(),
                                        [](const JobResult& one) { return !one.IsDone(); }));
}

JobRunResult RunJobs(const std::vector<Job>& jobs, const JobWork& work,
                     const JobRunOptions& options) {
  MakeFolder(options.folder);
  const std::set<std::string> done = NamesOfResults(options.folder);
  std::map<int, std::vector<const Job*>> open;
  for (const Job& job : jobs)
    if (done.count(job.name) == 0) open[job.stage].push_back(&job);
  int num_open = 0;
  for (const auto& [stage, of_stage] : open) num_open += static_cast<int>(of_stage.size());
  const int total = static_cast<int>(jobs.size());
  Progress progress(options, total - num_open, total);
  for (const auto& [stage, of_stage] : open) {
    if (!WhatStageWaitsFor(options.folder, jobs, stage).empty()) break;
    RunStage(of_stage, work, options, &progress);
  }
  JobRunResult result;
  result.results = ReadJobResults(options.folder, jobs);
  result.complete = result.results.size() == jobs.size();
  return result;
}

}  // namespace clothfit
