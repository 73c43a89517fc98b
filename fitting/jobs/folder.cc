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

}  // namespace

void PrepareJobFolder(const fs::path& folder, const std::string& file,
                      const std::string& description, const JobFolderOptions& options) {
  if (options.ranks.rank > 0) {
    WaitForFirst(folder, options.ranks);
    RequireSame(folder / file, description);
    return;
  }
  const bool exists = fs::exists(folder / file) || fs::exists(folder / "jobs");
  if (exists && !options.force && !options.resume) {
    throw InputError(folder.string(),
                     "already holds results; --force replaces them, --resume goes on with them");
  }
  if (options.resume && exists) RequireSame(folder / file, description);
  if (options.force) fs::remove_all(folder / "jobs");
  fs::create_directories(folder / "jobs");
  JobLedger::Clear(folder / "jobs");
  fs::remove(folder / "jobs" / "report.json");
  WriteWholeFile(folder / file, description);
  if (options.ranks.size > 1) WriteWholeFile(ReadyFile(folder, options.ranks), "");
}

}  // namespace clothfit
