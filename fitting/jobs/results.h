// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What came of jobs: NAME.json each, in a folder that all who do them see.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"

namespace clothfit {

// Of the jobs that have a result. One look at the folder, however many there are.
std::set<std::string> NamesOfResults(const std::filesystem::path& folder);

// Nothing where there is none yet. Throws InputError where the file is malformed.
std::optional<JobResult> ReadJobResult(const std::filesystem::path& folder,
                                       const std::string& name);
// In the list's order, of those that have one.
std::vector<JobResult> ReadJobResults(const std::filesystem::path& folder,
                                      const std::vector<Job>& jobs);

// The first job of an earlier stage that is not done, its problem with it; empty where the stage
// can begin.
std::string WhatStageWaitsFor(const std::filesystem::path& folder, const std::vector<Job>& jobs,
                              int stage);

// Whole or not at all, unless there is one already: the first counts. Throws InputError where it
// cannot be written.
void WriteJobResult(const std::filesystem::path& folder, const JobResult& result);

}  // namespace clothfit
