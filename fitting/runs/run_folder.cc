// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Making, replacing and opening run folders, and their short files.
#include "fitting/runs/run_folder.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
#include "fitting/files/version.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLog = "log.txt";
constexpr const char* kLogBegins = "clothfit ";
constexpr const char* kCheckpoint = "checkpoint.json";
constexpr const char* kSummary = "summary.json";
constexpr const char* kProgress = "progress.csv";

// All that a run ever writes. The log goes last: without it the folder is no run any more.
constexpr const char* kOwnFiles[] = {
    "config.yaml",   "parameters.yaml", kSummary,  "trajectory.npy", "mesh.obj",
    "residuals.csv", kCheckpoint,       kProgress, "report.html",    kLog};

bool IsRun(const fs::path& folder) {
  std::ifstream log(folder / kLog);
  std::string line;
  return std::getline(log, line) && line.rfind(kLogBegins, 0) == 0;
}

// An interrupted run has a checkpoint, or had no time for one.
bool IsFinished(const fs::path& folder) {
  if (fs::exists(folder / kCheckpoint) || !fs::exists(folder / kSummary)) return false;
  const nlohmann::json summary = nlohmann::json::parse(ReadTextFile(folder / kSummary), nullptr,
                                                       false);  // discarded where it is damaged
  return !summary.is_object() || summary.value("status", "") != ToString(FitStatus::kInterrupted);
}

void RequireRun(const fs::path& folder, const std::string& otherwise) {
  if (IsRun(folder)) return;
  throw InputError(folder.string(), "is not the folder of a run; " + otherwise);
}

void RemoveOwnFiles(const fs::path& folder) {
  for (const char* name : kOwnFiles) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (!error) continue;
    throw InputError((folder / name).string(), "cannot be replaced: " + error.message());
  }
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made: " + error.message());
}

// True where there is nothing, or an empty folder.
bool IsFree(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  // Beneath a file or in a closed folder there is nothing to see; making the folder will tell why.
  if (!fs::exists(status)) return true;
  if (!fs::is_directory(status)) throw InputError(folder.string(), "is a file; expected a folder");
  const fs::directory_iterator first(folder, error);
  if (error) throw InputError(folder.string(), "cannot be read: " + error.message());
  return first == fs::directory_iterator();
}

}  // namespace

RunFolder::RunFolder(const fs::path& folder, Existing existing) : path_(folder) {
  const bool is_free = IsFree(folder);
  if (existing == Existing::kResume) {
    if (is_free) throw InputError(folder.string(), "there is no run to resume");
    RequireRun(folder, "there is nothing to resume");
    if (!IsFinished(folder)) return;
    throw InputError(folder.string(), "the run is finished; there is nothing to resume");
  }
  if (!is_free) {
    if (existing == Existing::kRefuse) {
      throw InputError(folder.string(), IsRun(folder)
                                            ? "already holds a run; --force replaces it"
                                            : "is not empty; expected a new or empty folder");
    }
    RequireRun(folder, "only a run is replaced, expected one or a new or empty folder");
    RemoveOwnFiles(folder);
  }
  MakeFolder(folder);
  AppendLog(kLogBegins + Version());
}

RunFolder RunFolder::Open(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder.string(), "no such folder");
  RequireRun(folder, "expected one that 'clothfit fit' made");
  return RunFolder(folder);
}

void RunFolder::WriteConfig(const FitConfig& config) const {
  WriteWholeFile(ConfigFile(), ConfigToYaml(config));
}

void RunFolder::AppendLog(const std::string& line) const { AppendLine(path_ / kLog, line); }

void RunFolder::AppendProgress(const FitProgress& progress, double seconds) const {
  const fs::path file = path_ / kProgress;
  if (!fs::exists(file)) AppendLine(file, "stage,iteration,cost,simulated_frames,seconds");
  std::string stage = progress.stage;
  std::replace(stage.begin(), stage.end(), ',', ';');
  AppendLine(file, fmt::format("{},{},{},{},{:.3f}", stage, progress.iteration,
                               FormatNumber(progress.cost), FormatNumber(progress.simulated_frames),
                               seconds));
}

void RunFolder::RemoveCheckpoint() const {
  std::error_code ignored;  // one that stays behind does no harm
  fs::remove(path_ / kCheckpoint, ignored);
}

bool RunFolder::HasCheckpoint() const { return fs::exists(path_ / kCheckpoint); }

}  // namespace clothfit
