// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis on disk: diagnosis.json, diagnosis.md, config.yaml (the answer's, else the
// baseline's), log.txt; fit/, the fit of that as a run, which commands that read runs take; the
// cloth without and with what was found, baseline.npy and model.npy; where a force is missing,
// missing-force.npy, missing-force.png and missing-force-cloth.png. While it is not finished:
// fits/, the fits that are.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "tracking/files/output_folder.h"

namespace clothfit {

class DiagnosisFolder {
 public:
  using Existing = clothfit::Existing;

  // Makes the folder and begins its log; kResume goes on with that of an unfinished one, or
  // begins where there is nothing. Other commands are kept out of it as long as this lives.
  // Throws InputError as OutputFolder does, and where a finished one is to be resumed.
  DiagnosisFolder(const std::filesystem::path& folder, Existing existing);
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path KeptFits() const { return path_ / "fits"; }
  void AppendLog(const std::string& line) const;
  // An interrupted one can be gone on with afterwards; of others the kept fits are removed.
  void Write(const Diagnosis& diagnosis) const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<OutputFolder> output_;
};

}  // namespace clothfit
