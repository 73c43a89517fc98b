// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What all commands have in common that make lists of jobs, or do them.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "fitting/jobs/plan.h"
#include "tracking/files/output_folder.h"

namespace clothfit {

// -o, --threads, --force, --resume, --quiet, --slurm, --array-size, --sbatch, --prepare.
struct JobOptions {
  std::string output, sbatch;
  int threads = 0, array_size = 1000;
  bool force = false, resume = false, quiet = false, slurm = false, prepare = false;
};
void AddJobOptions(CLI::App* command, JobOptions* options);
void AddThreadsOption(CLI::App* command, int* threads);
// Throws InputError where a value is of no use.
void CheckJobOptions(const JobOptions& options);

// What is to be done with the jobs of the output folder, which has been prepared and is locked.
// Returns the exit status.
int RunPreparedJobs(FolderLock lock, const JobOptions& options);

// The list in a folder with what does it, by the command that made it. Throws InputError where
// there is none.
JobPlan OpenJobPlan(const std::filesystem::path& folder);

// Does what is left here, and prints the table.
int RunAllJobs(const JobPlan& plan, const std::filesystem::path& folder, int threads, bool quiet);

// Prints the table, tells what failed, and returns the exit status.
int FinishJobs(const PlanResult& result, const std::filesystem::path& folder, bool quiet);

}  // namespace clothfit
