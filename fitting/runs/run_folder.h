// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A run is a folder of clothfit's (tracking/files/output_folder.h): config.yaml, parameters.yaml,
// summary.json, trajectory.npy, mesh.obj, residuals.csv, log.txt, progress.csv and, while a fit is
// under way, checkpoint.bin.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "fitting/files/evaluation_journal.h"
#include "fitting/fit/fit.h"
#include "tracking/files/output_folder.h"

namespace clothfit {

class RunFolder {
 public:
  using Existing = clothfit::Existing;

  // Makes the folder and begins its log; other commands are kept out of it as long as this lives.
  // Throws InputError as OutputFolder does, and where there is no run to resume or a finished one.
  RunFolder(const std::filesystem::path& folder, Existing existing);
  // Of a fit of several recordings: as above, with recordings.yaml instead of a config, and room
  // for a run of each in recordings/NAME.
  static RunFolder OfSeveral(const std::filesystem::path& folder, Existing existing,
                             const std::vector<std::string>& names);
  static std::filesystem::path PlaceOf(const std::string& name);  // recordings/NAME
  // One of these runs, to write into; what is there stays.
  RunFolder OfRecording(const std::string& name) const;
  static constexpr const char* kOfDiagnosis = "fit";  // the run in a diagnosis' folder
  // An existing run, to read, or that of a diagnosis.
  static RunFolder Open(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return path_; }

  // Each file is written beside its place and moved there, so that it is whole or not there. Throws
  // InputError where the disk is full or the folder not writable.
  void WriteConfig(const FitConfig& config) const;
  void WriteParameters(const FitResult& result) const;
  void WriteSummary(const Scene& scene, const FitConfig& config, const FitResult& result) const;
  void WriteSummary(const nlohmann::ordered_json& summary) const;
  // trajectory.npy (float64, frames x particles x 3, m, world), mesh.obj (vt in metres) and
  // residuals.csv of one open-loop simulation from frame 0 on.
  void WriteTrajectory(const Scene& scene, const std::vector<Eigen::VectorXd>& positions) const;
  // Lists further files, or folders "NAME/" with a manifest of their own, before they are written.
  void Add(const std::vector<std::string>& files) const;
  void AppendLog(const std::string& line) const;
  // progress.csv: a row an iteration. `seconds`: since the fit began.
  void AppendProgress(const FitProgress& progress, double seconds) const;
  // Of a fit that is done again from its checkpoint and tells all of it once more.
  void RemoveProgress() const;

  // checkpoint.bin: what the fit has evaluated.
  bool HasCheckpoint() const;
  EvaluationJournal OpenCheckpoint() const { return EvaluationJournal(CheckpointFile()); }
  void RemoveCheckpoint() const;
  std::filesystem::path CheckpointFile() const { return path_ / "checkpoint.bin"; }
  std::filesystem::path ConfigFile() const { return path_ / "config.yaml"; }
  bool HasParameters() const;
  // The free vector of a run's parameters.yaml, in the order of `free`.
  Eigen::VectorXd ReadParameters(const FreeParameters& free) const;

 private:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}
  RunFolder(const std::filesystem::path& folder, FolderKind kind, Existing existing);
  void RequireUnfinished() const;
  void Begin(Existing existing, const std::vector<std::string>& more);
  std::filesystem::path path_;
  std::shared_ptr<OutputFolder> output_;  // null: to read only
};

}  // namespace clothfit
