// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A run is a folder: config.yaml, parameters.yaml, summary.json, trajectory.npy, mesh.obj,
// residuals.csv, log.txt, progress.csv and, while a fit is under way, checkpoint.json.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "fitting/fit/fit.h"

namespace clothfit {

class RunFolder {
 public:
  enum class Existing { kRefuse, kReplace, kResume };

  // Makes the folder and begins its log, by which a run is known. Throws InputError where it exists
  // and holds files (kRefuse), is not a run's (kReplace, kResume: nothing but a run's own files is
  // ever replaced), holds a finished run (kResume), or cannot be written.
  RunFolder(const std::filesystem::path& folder, Existing existing);
  // An existing run, to read.
  static RunFolder Open(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return path_; }

  // Each file is written beside its place and moved there, so that it is whole or not there. Throws
  // InputError where the disk is full or the folder not writable.
  void WriteConfig(const FitConfig& config) const;
  void WriteCheckpoint(const FitCheckpoint& checkpoint) const;
  void WriteParameters(const FitResult& result) const;
  void WriteSummary(const Scene& scene, const FitConfig& config, const FitResult& result) const;
  // trajectory.npy (float64, frames x particles x 3, m, world), mesh.obj (vt in metres) and
  // residuals.csv of one open-loop simulation from frame 0 on.
  void WriteTrajectory(const Scene& scene, const std::vector<Eigen::VectorXd>& positions) const;
  void AppendLog(const std::string& line) const;
  // progress.csv: a row an iteration. `seconds`: since the fit began.
  void AppendProgress(const FitProgress& progress, double seconds) const;
  void RemoveCheckpoint() const;

  bool HasCheckpoint() const;
  FitCheckpoint ReadCheckpoint() const;
  std::filesystem::path ConfigFile() const { return path_ / "config.yaml"; }
  // The free vector of a run's parameters.yaml, in the order of `free`.
  Eigen::VectorXd ReadParameters(const FreeParameters& free) const;

 private:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace clothfit
