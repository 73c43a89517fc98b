// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A list of jobs as job arrays of Slurm: what runs when, again, where and for how long is Slurm's.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "fitting/jobs/list.h"

namespace clothfit {

// Scripts, logs and what was submitted, in the folder of the jobs.
constexpr const char* kSlurmFolder = "slurm";

struct SlurmOptions {
  std::string program;    // clothfit, as the nodes find it
  int array_size = 1000;  // tasks of an array at most; with more jobs, a task does several
  std::string sbatch;     // options for sbatch: time, memory, partition
};

// Submits the jobs that have no result, an array a stage, each after the one before, and a last job
// that gathers the tables, whatever came of them. Returns what was submitted, for people. All or
// nothing is left in the queue. Throws InputError where Slurm refuses, or still has jobs of the
// folder.
std::string SubmitToSlurm(const std::filesystem::path& folder, const JobList& list,
                          const SlurmOptions& options);

struct SlurmTask {
  std::filesystem::path log;  // of its last run
  std::string state;          // RUNNING, PENDING, ...; empty where it is not in the queue any more
};
// Of each job that was submitted, by its number, the task that does it. `problem`: in words, where
// Slurm does not answer; no task has a state then.
std::map<int, SlurmTask> FindSlurmTasks(const std::filesystem::path& folder, const JobList& list,
                                        std::string* problem);

}  // namespace clothfit
