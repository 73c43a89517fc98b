// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/folder.h"

#include <chrono>
#include <thread>

#include "autodiff_sim/base/error.h"
#include "fitting/jobs/ledger.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestWait = 120.0;  // s, for the first of the processes

fs::path ReadyFile(const fs::path& folder, const Ranks& ranks) {
  return folder / "jobs" / ("ready-" + ranks.launch);
}

void WaitForFirst(const fs::path& folder, const Ranks& ranks) {
  for (double waited = 0.0; waited < kLongestWait; waited += 0.02) {
    if (fs::exists(ReadyFile(folder, ranks))) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  throw InputError(folder.string(),
                   "the first of the processes has not prepared it; do all of "
                   "them see the same folder?");
}

void RequireSame(const fs::path& file, const std::string& description) {
  if (fs::exists(file) && ReadTextFile(file) == description) return;
  throw InputError("--resume", "the options differ from those in " + file.string());
}

// Nobody works here: breaks all leases and forgets the losses, as before a study goes on.
void BreakLeases(const fs::path& folder) {
  const std::optional<Manifest> manifest = ReadManifest(folder);
  if (!manifest) return;
  std::set<std::string> signs;
  for (const std::string& file : manifest->All()) {
    const std::string ending = fs::path(file).extension().string();
    if (ending == ".lease" || ending == ".lost") signs.insert(file);
    if (file.back() == '/') BreakLeases(folder / fs::path(file).parent_path());
  }
  RemoveWritten(folder, signs);
}

std::vector<std::string> AllFiles(const JobFolderContents& contents, const Ranks& ranks) {
  std::vector<std::string> all = contents.files;
  const std::vector<std::string> of_jobs = LedgerFiles(contents.jobs),
                                 of_report = LedgerFiles({{"report", nullptr}});
  all.insert(all.end(), of_jobs.begin(), of_jobs.end());
  all.insert(all.end(), of_report.begin(), of_report.end());
  for (const Job& job : contents.jobs)
    if (contents.shares_searches) all.push_back("jobs/" + job.name + ".search/");
  if (ranks.size > 1) all.push_back("jobs/ready-" + ranks.launch);
  all.push_back(contents.file);
  return all;
}

}  // namespace

FolderLock PrepareJobFolder(const fs::path& folder, const JobFolderContents& contents,
                            const JobFolderOptions& options) {
  if (options.ranks.rank > 0) {
    WaitForFirst(folder, options.ranks);
    RequireSame(folder / contents.file, contents.description);
    return FolderLock(folder, FolderLock::Kind::kShared);
  }
  OutputFolder output(folder, contents.kind, contents.command,
                      ExistingIf(options.force, options.resume));
  if (options.resume && output.was_there())
    RequireSame(folder / contents.file, contents.description);
  if (options.resume) {
    BreakLeases(folder);
    output.Remove({"jobs/report.json"});
  }
  output.Begin(AllFiles(contents, options.ranks));
  for (const Job& job : contents.jobs) {
    if (!contents.shares_searches) break;
    OutputFolder(folder / "jobs" / (job.name + ".search"), FolderKind::kSearch, contents.command,
                 Existing::kResume)
        .Begin({});
  }
  WriteWholeFile(folder / contents.file, contents.description);
  FolderLock lock = output.TakeLock(options.ranks.size > 1);
  if (options.ranks.size > 1) WriteWholeFile(ReadyFile(folder, options.ranks), "");
  return lock;
}

std::vector<std::string> LedgerFiles(const std::vector<Job>& jobs) {
  std::vector<std::string> files;
  for (const Job& job : jobs)
    for (const std::string& file : JobLedger::FilesOf(job.name)) files.push_back("jobs/" + file);
  return files;
}

}  // namespace clothfit
