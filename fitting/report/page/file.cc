// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/file.h"

#include <optional>
#include <utility>

namespace clothfit {

namespace fs = std::filesystem;

PageFile::PageFile(fs::path file, Overwrite overwrite)
    : path_(std::move(file)), overwrite_(overwrite) {
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
  const std::optional<FolderKind> kind = KindOfFolder(folder);
  if (kind && path_.has_filename()) {
    folder_ = std::make_unique<OutputFolder>(folder, *kind, "report", Existing::kResume);
    folder_->CheckMayWrite(path_.filename().string());
  }
  CheckMayWrite(path_, overwrite_);
}

void PageFile::Write(std::string_view html) {
  if (folder_) folder_->Add({path_.filename().string()});
  WriteOutputFile(path_, html, overwrite_);
}

}  // namespace clothfit
