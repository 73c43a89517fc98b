// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/part_folder.h"

#include <system_error>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "tracking/files/manifest.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& folder, const std::string& reason) {
  throw InputError(folder.string(), "cannot be made: " + reason);
}

// File by file, into a folder that holds other things.
void MoveContents(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path place = to / entry.path().filename();
    const fs::file_status there = fs::symlink_status(place);
    if (fs::is_directory(there) && entry.is_directory()) {
      MoveContents(entry.path(), place);
    } else if (fs::exists(there) && place.filename() != kManifestFile) {
      throw InputError(place.string(), "is in the way, and not replaced");
    } else {
      fs::rename(entry.path(), place);
    }
  }
}

}  // namespace

PartFolder::PartFolder(fs::path place) : place_(std::move(place)), path_(PartName(place_)) {
  std::error_code error;
  fs::create_directories(place_.parent_path(), error);
  while (!error && !fs::create_directory(path_, error)) path_ = PartName(place_);
  if (error) Fail(place_, error.message());
}

PartFolder::~PartFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

bool PartFolder::MoveToFreePlace() {
  std::error_code error;
  fs::rename(path_, place_, error);
  if (!error) path_.clear();
  if (error && !fs::exists(place_)) Fail(place_, error.message());
  return !error;
}

void PartFolder::MoveToPlace() {
  RemoveWrittenFolder(place_);
  if (MoveToFreePlace()) return;
  try {
    MoveContents(path_, place_);
  } catch (const fs::filesystem_error& error) {
    Fail(place_, error.code().message());
  }
}

}  // namespace clothfit
