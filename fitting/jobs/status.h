// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a list of jobs is.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/jobs/list.h"

namespace clothfit {

// How many jobs are done, run, wait in Slurm's queue, have not been begun and have failed, and of
// those that failed the problem, or the end of the log of those that were lost. For people.
std::string DescribeStatus(const std::filesystem::path& folder, const JobList& list);

}  // namespace clothfit
