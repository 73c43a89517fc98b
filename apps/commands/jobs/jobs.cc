// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit job, jobs and status: the list of jobs in a folder, whoever does it.
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/commands/jobs/job_options.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/results.h"
#include "fitting/jobs/shell.h"
#include "fitting/jobs/status.h"
#include "tracking/files/folder_lock.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct ListOptions {
  std::string folder, range;
  int threads = 1;
  bool all = false, list = false, gather = false;
};

int RunRange(JobPlan plan, const fs::path& folder, const ListOptions& options) {
  const JobRange range = ParseJobRange(options.range, plan.list);
  const auto begin = plan.list.jobs.begin();
  const std::string missing =
      WhatStageWaitsFor(folder / kResultFolder, plan.list.jobs, begin[range.first].stage);
  if (!missing.empty()) throw InputError(folder.string(), "it is too early for that: " + missing);
  const std::vector<Job> own(begin + range.first, begin + range.last + 1);
  if (own.front().stage != own.back().stage)
    throw InputError("JOBS", "'" + options.range + "': jobs of two stages; expected those of one");
  JobRunOptions run;
  run.folder = folder / kResultFolder;
  run.num_threads = options.threads;
  run.threads_a_job = plan.threads_a_job;
  run.stop = StopOnInterrupt();
  const JobRunResult done = RunJobs(own, plan.work, run);
  if (*run.stop) return kExitInterrupted;
  const int status = FinishJobs({done, ""}, folder, true);
  if (status == kExitSuccess) PrintNext("clothfit status " + ShellWord(folder.string()));
  return status;
}

int RunJobCommand(const ListOptions& options) {
  if (options.threads < 0)
    throw InputError("--threads", fmt::format("{}: expected 0 or more", options.threads));
  const fs::path folder = options.folder;
  if (options.all == !options.range.empty())
    throw InputError("JOBS", "expected the number of a job, or --all");
  JobPlan plan = OpenJobPlan(folder);
  const FolderLock lock(folder, options.all ? FolderLock::Kind::kAlone : FolderLock::Kind::kShared);
  if (options.all) return RunAllJobs(plan, folder, options.threads, false);
  return RunRange(std::move(plan), folder, options);
}

// Of the first stage that is not done.
int PrintOpenJobs(const fs::path& folder) {
  const JobList list = ReadJobList(folder);
  const std::set<std::string> ended = NamesOfResults(folder / kResultFolder);
  const std::string command = ShellWord(OwnProgram()) + " job " +
                              ShellWord(fs::absolute(folder).lexically_normal().string());
  std::optional<int> stage;
  for (std::size_t i = 0; i < list.jobs.size(); ++i) {
    const Job& job = list.jobs[i];
    if (ended.count(job.name) > 0) continue;
    if (!stage) stage = job.stage;
    if (job.stage == *stage) fmt::print("{} {}\n", command, i);
  }
  if (!stage) return kExitSuccess;
  const std::string missing = WhatStageWaitsFor(folder / kResultFolder, list.jobs, *stage);
  if (!missing.empty()) throw InputError(folder.string(), "nothing can go on: " + missing);
  return kExitSuccess;
}

int Gather(const fs::path& folder) {
  const JobPlan plan = OpenJobPlan(folder);
  const PlanResult result = GatherResults(plan, folder);
  const int status = FinishJobs(result, folder, false);
  if (result.jobs.complete) return status;
  Print(Terminal(), "clothfit: error: {} of {} jobs have no result; see clothfit status {}\n",
        plan.list.jobs.size() - result.jobs.results.size(), plan.list.jobs.size(),
        ShellWord(folder.string()));
  return kExitFailure;
}

int RunStatusCommand(const fs::path& folder) {
  const JobStatus status = StatusOfJobs(folder, ReadJobList(folder));
  Print("{}", status.words);
  const std::string place = ShellWord(folder.string());
  if (status.is_under_way) {
    PrintNext("clothfit status " + place + ", later");
  } else {
    PrintNext(status.is_complete ? "clothfit jobs " + place + " --gather"
                                 : "clothfit job " + place + " --all");
  }
  return kExitSuccess;
}

CLI::App* AddFolderCommand(CLI::App* app, const std::string& name, const std::string& doc,
                           std::string* folder) {
  CLI::App* const command = app->add_subcommand(name, doc);
  command->add_option("FOLDER", *folder, "of a study, trials or a batch")->required();
  return command;
}

}  // namespace

void AddJobCommand(CLI::App* app, Action* action) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App* const job = AddFolderCommand(
      app, "job", "do one job of a list, some, or all that are left", &options->folder);
  job->add_option("JOBS", options->range, "its number, from 0, or two: 30-39");
  job->add_flag("--all", options->all, "all that have no result, and the tables");
  AddThreadsOption(job, &options->threads);
  job->footer(
      "Examples:\n"
      "  clothfit job studies/cameras 7\n"
      "  clothfit job studies/cameras --all");
  job->callback([=] { *action = [=] { return RunJobCommand(*options); }; });
}

void AddJobsCommand(CLI::App* app, Action* action) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App* const jobs =
      AddFolderCommand(app, "jobs", "what is left to do, as commands; tables", &options->folder);
  jobs->add_flag("--list", options->list, "print the commands that can be run now, one a job");
  jobs->add_flag("--gather", options->gather, "write the tables of what is done");
  jobs->footer(
      "Examples:\n"
      "  clothfit jobs studies/cameras --list | parallel\n"
      "  clothfit jobs studies/cameras --gather");
  jobs->callback([=] {
    *action = [=] {
      if (options->list == options->gather)
        throw InputError("jobs", "expected one of --list and --gather");
      return options->list ? PrintOpenJobs(options->folder) : Gather(options->folder);
    };
  });
}

void AddStatusCommand(CLI::App* app, Action* action) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* const status = AddFolderCommand(
      app, "status", "how many jobs are done, run and have failed, and why", folder.get());
  status->footer("Example:\n  clothfit status studies/cameras");
  status->callback([=] { *action = [=] { return RunStatusCommand(*folder); }; });
}

}  // namespace clothfit
