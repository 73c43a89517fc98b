// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/folder.h"

#include "autodiff_sim/base/error.h"
#include "fitting/jobs/slurm.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> AllFiles(const JobFolderContents& contents) {
  std::vector<std::string> all = contents.files;
  for (const Job& job : contents.list.jobs)
    all.push_back(std::string(kResultFolder) + "/" + job.name + ".json");
  all.insert(all.end(), {contents.file, kJobListFile, std::string(kSlurmFolder) + "/"});
  return all;
}

}  // namespace

FolderLock PrepareJobFolder(const fs::path& folder, const JobFolderContents& contents,
                            Existing existing) {
  OutputFolder output(folder, contents.kind, contents.list.command, existing);
  if (existing == Existing::kResume && output.was_there()) {
    const fs::path file = folder / contents.file;
    if (!fs::exists(file) || ReadTextFile(file) != contents.description)
      throw InputError("--resume", "the options differ from those in " + file.string());
  }
  output.Begin(AllFiles(contents));
  WriteWholeFile(folder / contents.file, contents.description);
  WriteWholeFile(folder / kJobListFile, JobListAsText(contents.list));
  return output.TakeLock();
}

}  // namespace clothfit
