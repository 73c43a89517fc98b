// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/plan.h"

#include "fitting/jobs/results.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

PlanResult WithTables(const JobPlan& plan, JobRunResult jobs) {
  PlanResult result{std::move(jobs), ""};
  if (result.jobs.complete || (plan.reports_partly && !result.jobs.results.empty()))
    result.table = plan.report(result.jobs.results);
  return result;
}

}  // namespace

PlanResult RunPlan(const JobPlan& plan, const fs::path& folder, JobRunOptions options) {
  options.folder = folder / kResultFolder;
  options.threads_a_job = plan.threads_a_job;
  return WithTables(plan, RunJobs(plan.list.jobs, plan.work, options));
}

PlanResult GatherResults(const JobPlan& plan, const fs::path& folder) {
  JobRunResult jobs;
  jobs.results = ReadJobResults(folder / kResultFolder, plan.list.jobs);
  jobs.complete = jobs.results.size() == plan.list.jobs.size();
  return WithTables(plan, std::move(jobs));
}

}  // namespace clothfit
