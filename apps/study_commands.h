// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The studies that are lists of jobs, and what all commands that do such lists have in common.
#pragma once

#include <functional>
#include <string>

#include "apps/commands.h"
#include "fitting/studies/run_study.h"

namespace clothfit {

// -o, --threads, --patience, --force, --resume, --quiet.
struct JobOptions {
  std::string output;
  int threads = 0;
  double patience = 300.0;  // s
  bool force = false, resume = false, quiet = false;
};
void AddJobOptions(CLI::App* command, JobOptions* options);
// Throws InputError where a value is of no use.
void CheckJobOptions(const JobOptions& options);

class ProgressDisplay;
// With a display of what is done, on the first of many processes. `stage` must outlive it.
StudyRunOptions MakeRunOptions(const JobOptions& options, ProgressDisplay* display,
                               std::string* stage);

// The text of the report (see RunReport); empty where it was stopped. Throws std::runtime_error
// where it failed.
std::string RunReportOnCommand(const std::function<std::string()>& write,
                               const JobRunOptions& options);

// Prints the table, tells what failed, and returns the exit status. Does not return where threads
// hang.
int FinishJobs(const StudyRun& run, const JobOptions& options, const StudyRunOptions& run_options);

// attraction, reconstructions, ...: those of fitting/studies.
void AddJobStudies(CLI::App* study, Action* action);

}  // namespace clothfit
