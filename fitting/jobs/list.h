// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The list of jobs in a folder, jobs.json: all that whoever does one of them has to know.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"

namespace clothfit {

constexpr const char* kJobListFile = "jobs.json";
constexpr const char* kResultFolder = "jobs";

struct JobList {
  std::string command;     // that made it: "study cameras", "trials", "batch"
  nlohmann::json options;  // what all its jobs have in common, as the command has it
  std::vector<Job> jobs;   // numbered by their place, from 0
};

std::string JobListAsText(const JobList& list);
// Throws InputError where the folder has no list, or one of another version of clothfit, whose
// numbers may be others.
JobList ReadJobList(const std::filesystem::path& folder);

// A run of consecutive jobs.
struct JobRange {
  int first = 0, last = 0;
};
// "7" or "30-39" (to the last job, where that comes before). Throws InputError where it is neither.
JobRange ParseJobRange(const std::string& text, const JobList& list);

}  // namespace clothfit
