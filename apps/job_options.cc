// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of jobs on the command line: where, by how many, and how they end.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "apps/interrupt.h"
#include "apps/progress_display.h"
#include "apps/study_commands.h"
#include "apps/terminal.h"
#include "autodiff_sim/base/error.h"

namespace clothfit {

void AddJobOptions(CLI::App* command, JobOptions* options) {
  command->add_option("-o,--output", options->output, "folder of results and tables")
      ->type_name("FOLDER")
      ->required();
  command
      ->add_option("--threads", options->threads,
                   "jobs at the same time, 0: all cores, and of many processes one each; no "
                   "influence on the results")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--patience", options->patience,
                   "s without a sign of life until a job is given to somebody else")
      ->type_name("S")
      ->capture_default_str();
  command->add_flag("--force", options->force,
                    "replace the results that are there; other files stay");
  command->add_flag("--resume", options->resume, "go on with what is there")->excludes("--force");
  command->add_flag("--quiet", options->quiet, "print errors only");
}

void CheckJobOptions(const JobOptions& options) {
  if (options.threads < 0)
    throw InputError("--threads", fmt::format("{}: expected 0 or more", options.threads));
  if (!(options.patience > 0.0))
    throw InputError("--patience", fmt::format("{}: expected a number above 0", options.patience));
}

StudyRunOptions MakeRunOptions(const JobOptions& options, ProgressDisplay* display,
                               std::string* stage) {
  StudyRunOptions run;
  run.folder.ranks = FindRanks();
  run.folder.force = options.force;
  run.folder.resume = options.resume;
  run.jobs.folder = options.output;
  run.jobs.num_threads = options.threads == 0 && run.folder.ranks.size > 1 ? 1 : options.threads;
  run.jobs.patience = options.patience;
  run.jobs.stop = StopOnInterrupt();
  run.stage = [stage](const std::string& name) { *stage = name; };
  if (options.quiet || run.folder.ranks.rank > 0) return run;
  run.jobs.progress = [display, stage](int done, int total) {
    display->Show(*stage, fmt::format("{} of {}", done, total),
                  total > 0 ? static_cast<double>(done) / total : 1.0);
  };
  return run;
}

std::string RunReportOnCommand(const std::function<std::string()>& write,
                               const JobRunOptions& options) {
  const JobRunResult written = RunReport(write, options);
  if (!written.complete) return "";
  if (!written.results[0].IsDone()) throw std::runtime_error(written.FirstProblem());
  return written.results[0].output.get<std::string>();
}

int FinishJobs(const StudyRun& run, const JobOptions& options, const StudyRunOptions& run_options) {
  const bool is_first = run_options.folder.ranks.rank == 0;
  if (is_first && !options.quiet && !run.table.empty())
    fmt::print("{}\n{}\n", run.table, options.output);
  int status = kExitSuccess;
  if (*run_options.jobs.stop) {
    status = kExitInterrupted;
    fmt::print(Terminal(), "clothfit: interrupted; the same command with --resume goes on\n");
  } else if (run.num_problems > 0) {
    status = kExitFailure;
    if (is_first) {
      fmt::print(Terminal(), "clothfit: error: {} of the jobs failed; the first: {}\n",
                 run.num_problems, run.first_problem);
    }
  }
  std::fflush(nullptr);
  if (run.num_hanging > 0) std::_Exit(status);
  return status;
}

}  // namespace clothfit
