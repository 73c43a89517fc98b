// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Does a list of jobs, together with whoever else does the same list.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"

namespace clothfit {

struct JobRunOptions {
  std::filesystem::path folder;  // of the ledger; what it has done already is not done again
  int num_threads = 1;           // of this process; 0: all cores
  // s without a sign of life after which a worker counts as lost. Longer than any single
  // simulation, and than the file system takes to show one machine what another wrote.
  double patience = 300.0;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(int done, int total)> progress;  // one call at a time
};

struct JobRunResult {
  std::vector<JobResult> results;  // in the list's order; of those that have one
  bool complete = false;           // all of them
  // Threads that hang: the process should leave by _Exit, for they cannot be ended.
  int num_hanging = 0;

  // The first problem; empty where all jobs are done.
  std::string FirstProblem() const;
  int CountProblems() const;
};

// Calls `work` for each job that nobody else does, and returns when all have results, from here or
// elsewhere, or when it is stopped. A thread that hangs is replaced. `work` and what it refers to
// have to outlive the process where threads hang.
JobRunResult RunJobs(const std::vector<Job>& jobs, const JobWork& work,
                     const JobRunOptions& options);

// Has one of the processes, whichever, write the tables of jobs that are done: a job like the
// others, named "report". Its output is the text that `write` returns, in all processes.
JobRunResult RunReport(const std::function<std::string()>& write, const JobRunOptions& options);

}  // namespace clothfit
