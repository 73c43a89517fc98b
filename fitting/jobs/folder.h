// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a list of jobs: made once, by one of many processes, and never replaced unasked.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/jobs/ranks.h"

namespace clothfit {

struct JobFolderOptions {
  Ranks ranks;
  bool force = false;   // replace the results that are there
  bool resume = false;  // go on with them, or begin where there are none
};

// Writes `description`, all that decides the results, as `file` into the folder; the first process
// does, the others wait for it. The jobs' ledger is folder/jobs. Throws InputError where results
// are there and nobody said what to do with them, or those to go on with are of something else.
void PrepareJobFolder(const std::filesystem::path& folder, const std::string& file,
                      const std::string& description, const JobFolderOptions& options);

}  // namespace clothfit
