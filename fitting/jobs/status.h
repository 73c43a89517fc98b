// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a list of jobs is.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/jobs/list.h"

namespace clothfit {

struct JobStatus {
  // How many jobs are done, run, wait in Slurm's queue, have not been begun and have failed, and of
  // those that failed the problem, or the end of the log of those that were lost. For people.
  std::string words;
  bool is_under_way = false;  // some run or wait, or may do so where Slurm does not answer
  bool is_complete = false;   // each has a result, be it a problem
};
JobStatus StatusOfJobs(const std::filesystem::path& folder, const JobList& list);

}  // namespace clothfit
