// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A list of jobs with what it takes to do them and to make tables of their results.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fitting/jobs/list.h"
#include "fitting/jobs/run_jobs.h"

namespace clothfit {

struct JobPlan {
  JobList list;
  JobWork work;
  // Writes the tables of these results and returns the one for people. Of the same results it
  // writes the same files, but for seconds.
  std::function<std::string(const std::vector<JobResult>& results)> report;
  bool reports_partly = false;  // tables of some of the jobs are of use, too
  int threads_a_job = 1;        // that a job can make use of
};

struct PlanResult {
  JobRunResult jobs;
  std::string table;  // for people; empty where there is none yet
};

// Does what has no result in the folder, and writes the tables. The options' folder is not used.
PlanResult RunPlan(const JobPlan& plan, const std::filesystem::path& folder, JobRunOptions options);
// Writes the tables of what others have done.
PlanResult GatherResults(const JobPlan& plan, const std::filesystem::path& folder);

}  // namespace clothfit
