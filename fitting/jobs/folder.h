// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a list of jobs: made once, by one of many processes, and never replaced unasked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"
#include "fitting/jobs/ranks.h"
#include "tracking/files/output_folder.h"

namespace clothfit {

struct JobFolderOptions {
  Ranks ranks;
  bool force = false;   // replace the results that are there
  bool resume = false;  // go on with them, or begin where there are none
};

// All that the processes write there, beside the ledger of the jobs, which is in jobs/.
struct JobFolderContents {
  FolderKind kind = FolderKind::kStudy;
  std::string command;
  std::string file, description;   // the file that says all that decides the results
  std::vector<Job> jobs;           // "report" is one more
  std::vector<std::string> files;  // and folders "NAME/" with a manifest of their own
  bool shares_searches = false;    // the points of a job's search are in jobs/NAME.search
};

// Lists the contents in the folder's manifest and writes its description; the first process does,
// the others wait for it. Returns the lock that keeps other commands out. Throws InputError where
// results are there and nobody said what to do with them, or those to go on with are of something
// else.
FolderLock PrepareJobFolder(const std::filesystem::path& folder, const JobFolderContents& contents,
                            const JobFolderOptions& options);

// The ledger's files of these jobs, in jobs/.
std::vector<std::string> LedgerFiles(const std::vector<Job>& jobs);

}  // namespace clothfit
