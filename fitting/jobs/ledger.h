// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Who does which job, and what came of it: a folder that all workers share, on one machine or, by a
// network file system, on many. See docs/adr/0006-workers-share-a-folder.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"

namespace clothfit {

// A job is open, taken (NAME.lease: by whom; its time is the last sign of life) or done
// (NAME.json). A lease is void where its holder has died, as far as that can be seen from this
// machine, or has been silent for `patience` seconds. Whoever finds it so breaks it and notes the
// loss (NAME.lost); a job that was lost too often is given up.
class JobLedger {
 public:
  // Makes the folder. `worker` tells the workers of one process apart. Throws InputError where it
  // cannot be written.
  JobLedger(std::filesystem::path folder, double patience, int worker);

  static constexpr int kMostLosses = 3;

  // The result, once there is one. Throws InputError where the file is malformed.
  std::optional<JobResult> Read(const std::string& name) const;
  bool HasResult(const std::string& name) const;

  // True where the job is now this worker's: nobody has it, or who had it is lost.
  bool Take(const std::string& name);
  // A sign of life from the holder. Cheap: the file is touched once a second at most.
  void Alive(const std::string& name);
  void Release(const std::string& name);
  // Writes the result, whole or not at all, unless there is one already: the first counts.
  void Record(const JobResult& result);

  // The files that a ledger keeps of a job, in its folder.
  static std::vector<std::string> FilesOf(const std::string& name);

 private:
  std::filesystem::path File(const std::string& name, const char* ending) const;
  bool IsVoid(const std::filesystem::path& lease) const;
  void Break(const std::string& name);
  bool IsOurs(const std::string& name) const;

  std::filesystem::path folder_;
  double patience_;    // s
  std::string token_;  // host, process, worker
  double last_sign_ = 0.0;
};

}  // namespace clothfit
