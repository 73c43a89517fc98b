// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Does jobs by the threads of this process. See docs/adr/0013-clusters-bring-their-scheduler.md for
// more than one process.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"

namespace clothfit {

struct JobRunOptions {
  std::filesystem::path folder;  // of the results; what has one is not done again
  int num_threads = 1;           // 0: all cores
  int threads_a_job = 1;         // that a job can make use of
  const std::atomic<bool>* stop = nullptr;
  std::function<void(int done, int total)> progress;  // one call at a time
};

struct JobRunResult {
  std::vector<JobResult> results;  // in the list's order; of those that have one
  bool complete = false;           // all of them

  // The first problem; empty where all jobs are done.
  std::string FirstProblem() const;
  int CountProblems() const;
};

// Does the jobs that have no result yet, stage by stage; a stage in which a job has a problem is
// the last. Makes the folder. Throws InputError where a result can be neither read nor written.
JobRunResult RunJobs(const std::vector<Job>& jobs, const JobWork& work,
                     const JobRunOptions& options);

}  // namespace clothfit
