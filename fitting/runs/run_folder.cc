// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Making, replacing and opening run folders, and their short files.
#include "fitting/runs/run_folder.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "fitting/files/version.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLog = "log.txt";
constexpr const char* kCheckpoint = "checkpoint.bin";
constexpr const char* kSummary = "summary.json";
constexpr const char* kProgress = "progress.csv";

// Those of the run of one recording, that a fit of several has not.
std::vector<std::string> FilesOfOne() {
  return {"config.yaml", "trajectory.npy", "mesh.obj", "residuals.csv"};
}

// An interrupted run has a checkpoint, or had no time for one.
bool IsFinished(const fs::path& folder) {
  if (IsThere(folder / kCheckpoint) || !IsThere(folder / kSummary)) return false;
  const nlohmann::json summary = nlohmann::json::parse(ReadJsonText(folder / kSummary), nullptr,
                                                       false);  // discarded where it is damaged
  return !summary.is_object() || summary.value("status", "") != ToString(FitStatus::kInterrupted);
}

}  // namespace

RunFolder::RunFolder(const fs::path& folder, FolderKind kind, Existing existing)
    : path_(folder), output_(std::make_shared<OutputFolder>(folder, kind, "fit", existing)) {}

void RunFolder::RequireUnfinished() const {
  const fs::path whole = fs::absolute(path_).lexically_normal().parent_path().parent_path();
  if (KindOfFolder(whole) == FolderKind::kJointRun) {
    throw InputError(path_.string(),
                     "is of a fit of several recordings; expected that, " + whole.string());
  }
  if (!output_->was_there()) throw InputError(path_.string(), "there is no run to resume");
  if (IsFinished(path_))
    throw InputError(path_.string(), "the run is finished; there is nothing to resume");
}

void RunFolder::Begin(Existing existing, const std::vector<std::string>& more) {
  std::vector<std::string> files = {"parameters.yaml", kSummary, kCheckpoint, kProgress, kLog};
  files.insert(files.end(), more.begin(), more.end());
  const bool goes_on = existing == Existing::kResume && output_->was_there();
  output_->Begin(files);
  if (!goes_on) AppendLog("clothfit " + Version());
}

RunFolder::RunFolder(const fs::path& folder, Existing existing)
    : RunFolder(folder, FolderKind::kRun, existing) {
  if (existing == Existing::kResume) RequireUnfinished();
  Begin(existing, FilesOfOne());
}

RunFolder RunFolder::OfSeveral(const fs::path& folder, Existing existing,
                               const std::vector<std::string>& names) {
  RunFolder run(folder, FolderKind::kJointRun, existing);
  if (existing == Existing::kResume) run.RequireUnfinished();
  std::vector<std::string> files = {"recordings.yaml"};
  for (const std::string& name : names) files.push_back(PlaceOf(name).string() + "/");
  run.Begin(existing, files);
  return run;
}

fs::path RunFolder::PlaceOf(const std::string& name) { return fs::path("recordings") / name; }

RunFolder RunFolder::OfRecording(const std::string& name) const {
  RunFolder run(path_ / PlaceOf(name), FolderKind::kRun, Existing::kResume);
  run.Begin(Existing::kResume, FilesOfOne());
  return run;
}

RunFolder RunFolder::Open(const fs::path& folder) {
  CheckInputFolder(folder);
  const std::optional<FolderKind> kind = KindOfFolder(folder);
  if (kind == FolderKind::kRun) return RunFolder(folder);
  if (kind == FolderKind::kDiagnosis && KindOfFolder(folder / kOfDiagnosis) == FolderKind::kRun)
    return RunFolder(folder / kOfDiagnosis);
  if (kind == FolderKind::kJointRun) {
    throw InputError(folder.string(), "is a fit of several recordings; expected the run of one, " +
                                          (folder / PlaceOf("NAME")).string());
  }
  if (IsRecordingFolder(folder)) {
    throw InputError(folder.string(), "is a recording; 'clothfit report " + folder.string() +
                                          "' shows it, 'clothfit fit " + folder.string() +
                                          " -o RUN' makes a run of it");
  }
  throw InputError(folder.string(),
                   "is not the folder of a run; expected one that 'clothfit fit' "
                   "made" +
                       (kind ? ", found " + InWords(*kind) : ""));
}

void RunFolder::Add(const std::vector<std::string>& files) const { output_->Add(files); }

void RunFolder::WriteConfig(const FitConfig& config) const {
  WriteWholeFile(ConfigFile(), ConfigToYaml(config));
}

void RunFolder::AppendLog(const std::string& line) const { AppendLine(path_ / kLog, line); }

void RunFolder::AppendProgress(const FitProgress& progress, double seconds) const {
  const fs::path file = path_ / kProgress;
  if (!IsThere(file)) AppendLine(file, "stage,iteration,cost,simulated_frames,seconds");
  std::string stage = progress.stage;
  std::replace(stage.begin(), stage.end(), ',', ';');
  AppendLine(file, fmt::format("{},{},{},{},{:.3f}", stage, progress.iteration,
                               FormatNumber(progress.cost), FormatNumber(progress.simulated_frames),
                               seconds));
}

void RunFolder::RemoveCheckpoint() const {
  std::error_code ignored;  // one that stays behind does no harm
  fs::remove(CheckpointFile(), ignored);
}

void RunFolder::RemoveProgress() const {
  std::error_code ignored;
  fs::remove(path_ / kProgress, ignored);
}

bool RunFolder::HasCheckpoint() const { return IsThere(CheckpointFile()); }

}  // namespace clothfit
