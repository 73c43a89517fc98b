// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of jobs on the command line: where, by whom, and how they end.
#include "apps/commands/jobs/job_options.h"

#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "apps/options/config.h"
#include "apps/process/exit_status.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/batch/batch.h"
#include "fitting/jobs/shell.h"
#include "fitting/jobs/slurm.h"
#include "fitting/studies/study_plan.h"
#include "fitting/trials/trial_jobs.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

int PrintPrepared(const std::string& folder) {
  const std::string program = ShellWord(OwnProgram()), place = ShellWord(folder);
  fmt::print(
      "{0} jobs {1} --list     # commands that can be run now, by anything, until there are none\n"
      "{0} jobs {1} --gather   # then the tables\n",
      program, place);
  return kExitSuccess;
}

int Submit(const JobOptions& options) {
  const fs::path folder = options.output;
  SlurmOptions slurm;
  slurm.program = OwnProgram();
  slurm.array_size = options.array_size;
  slurm.sbatch = options.sbatch;
  const std::string submitted = SubmitToSlurm(folder, ReadJobList(folder), slurm);
  if (!options.quiet) {
    Print("{}", submitted);
    PrintNext("clothfit status " + ShellWord(options.output));
  }
  return kExitSuccess;
}

}  // namespace

void AddThreadsOption(CLI::App* command, int* threads) {
  command
      ->add_option("--threads", *threads,
                   "jobs at the same time, 0: all cores; no influence on the results")
      ->type_name("N")
      ->capture_default_str();
}

void AddJobOptions(CLI::App* command, JobOptions* options) {
  BeginGroup(command, "The results");
  command->add_option("-o,--output", options->output, "folder of results and tables")
      ->type_name("FOLDER")
      ->required();
  AddThreadsOption(command, &options->threads);
  command->add_flag("--force", options->force,
                    "replace the results that are there; other files stay");
  command->add_flag("--resume", options->resume, "go on with what is there")->excludes("--force");
  command->add_flag("--quiet", options->quiet, "print errors only");
  BeginGroup(command, "On a cluster");
  CLI::Option* const slurm = command->add_flag(
      "--slurm", options->slurm, "submit what has no result to Slurm, and do nothing here");
  command
      ->add_option("--array-size", options->array_size,
                   "tasks of a job array at most; a task does as many jobs as that takes")
      ->type_name("N")
      ->capture_default_str()
      ->needs(slurm);
  command->add_option("--sbatch", options->sbatch, "options for sbatch: --time, --mem, ...")
      ->type_name("OPTIONS")
      ->needs(slurm);
  command->add_flag("--prepare", options->prepare, "write the list of jobs only, see clothfit jobs")
      ->excludes(slurm);
}

void CheckJobOptions(const JobOptions& options) {
  if (options.threads < 0)
    throw InputError("--threads", fmt::format("{}: expected 0 or more", options.threads));
  if (options.array_size < 1)
    throw InputError("--array-size", fmt::format("{}: expected 1 or more", options.array_size));
  if (options.sbatch.find('\n') != std::string::npos)
    throw InputError("--sbatch", "has more than one line; expected options as on a command line");
}

JobPlan OpenJobPlan(const fs::path& folder) {
  JobList list = ReadJobList(folder);
  try {
    if (list.command == "batch") return BatchPlan(std::move(list), folder);
    if (list.command == "trials") return PlanOfTrials(std::move(list), folder);
    if (const std::optional<Study> study = StudyOf(list))
      return StudyPlan(*study, std::move(list), folder);
  } catch (const nlohmann::json::exception& error) {
    throw InputError((folder / kJobListFile).string(), std::string("options: ") + error.what());
  }
  throw InputError((folder / kJobListFile).string(),
                   "command: '" + list.command + "'; expected a study, trials or batch");
}

int RunAllJobs(const JobPlan& plan, const fs::path& folder, int threads, bool quiet) {
  ProgressDisplay display;
  JobRunOptions run;
  run.num_threads = threads;
  run.stop = StopOnInterrupt();
  run.progress = [&](int done, int total) {
    if (plan.reports_partly && done > 0 && done < total) GatherResults(plan, folder);
    if (quiet) return;
    display.Show("jobs", fmt::format("{} of {}", done, total),
                 total > 0 ? static_cast<double>(done) / total : 1.0);
  };
  const PlanResult result = RunPlan(plan, folder, run);
  display.Finish();
  const int status = FinishJobs(result, folder, quiet);
  if (!*run.stop) return status;
  Print(Terminal(), "clothfit: interrupted; the same command with --resume goes on\n");
  return kExitInterrupted;
}

int FinishJobs(const PlanResult& result, const fs::path& folder, bool quiet) {
  if (!quiet && !result.table.empty()) Print("{}\n{}\n", result.table, folder.string());
  if (result.jobs.CountProblems() == 0) {
    if (!quiet && result.jobs.complete) PrintNext("clothfit report " + ShellWord(folder.string()));
    return kExitSuccess;
  }
  Print(Terminal(), "clothfit: error: {} of the jobs failed; the first: {}\n",
        result.jobs.CountProblems(), result.jobs.FirstProblem());
  return kExitFailure;
}

int RunPreparedJobs(FolderLock lock, const JobOptions& options) {
  if (options.prepare) return PrintPrepared(options.output);
  if (options.slurm) {
    { const FolderLock ended = std::move(lock); }  // tasks may begin while others are submitted
    return Submit(options);
  }
  const fs::path folder = options.output;
  return RunAllJobs(OpenJobPlan(folder), folder, options.threads, options.quiet);
}

}  // namespace clothfit
