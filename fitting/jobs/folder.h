// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a list of jobs: made once, and never replaced unasked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/jobs/list.h"
#include "tracking/files/output_folder.h"

namespace clothfit {

// All that is written there.
struct JobFolderContents {
  FolderKind kind = FolderKind::kStudy;
  JobList list;
  std::string file, description;   // the file that says all that decides the results
  std::vector<std::string> files;  // tables and pictures; folders "NAME/" with their own manifest
};

// Lists the contents in the folder's manifest, and writes the list and its description. Returns the
// lock that keeps other commands out. Throws InputError where results are there and nobody said
// what to do with them, or those to go on with are of something else.
FolderLock PrepareJobFolder(const std::filesystem::path& folder, const JobFolderContents& contents,
                            Existing existing);

}  // namespace clothfit
