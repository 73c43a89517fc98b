// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis on disk: diagnosis.json, diagnosis.md, config.yaml (the answer's, else the
// baseline's), log.txt; the cloth without and with what was found, baseline.npy and model.npy;
// where a force is missing, missing-force.npy, missing-force.png and missing-force-cloth.png. While
// it is not finished: fits/, the fits that are.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

class DiagnosisFolder {
 public:
  enum class Existing { kRefuse, kReplace, kResume };

  // Makes the folder and begins its log; kResume goes on with that of an unfinished one, or begins
  // where there is nothing. Throws InputError where it holds files and they may not be replaced, or
  // are not a diagnosis, or a finished one (kResume), or where it cannot be written.
  DiagnosisFolder(const std::filesystem::path& folder, Existing existing);
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path KeptFits() const { return path_ / "fits"; }
  void AppendLog(const std::string& line) const;
  // An interrupted one can be gone on with afterwards; of others the kept fits are removed.
  void Write(const Diagnosis& diagnosis) const;

 private:
  std::filesystem::path path_;
};

}  // namespace clothfit
