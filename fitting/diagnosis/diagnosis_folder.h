// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis on disk: diagnosis.json, diagnosis.md, config.yaml (the answer's, else the
// baseline's), log.txt; the cloth without and with what was found, baseline.npy and model.npy;
// where a force is missing, missing-force.npy, missing-force.png and missing-force-cloth.png.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/diagnosis/diagnosis.h"

namespace clothfit {

class DiagnosisFolder {
 public:
  // Makes the folder and begins its log. Throws InputError where it holds files and they may not be
  // replaced, or are not a diagnosis, or where it cannot be written.
  DiagnosisFolder(const std::filesystem::path& folder, bool replace);
  const std::filesystem::path& path() const { return path_; }
  void AppendLog(const std::string& line) const;
  void Write(const Diagnosis& diagnosis) const;

 private:
  std::filesystem::path path_;
};

}  // namespace clothfit
