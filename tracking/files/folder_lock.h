// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Keeps two commands out of one folder. The lock is the system's, on an open file, and so ends with
// its holder, however that ends.
#pragma once

#include <filesystem>
#include <utility>

namespace clothfit {

constexpr const char* kLockFile = ".clothfit.lock";

class FolderLock {
 public:
  // kAlone: of a command on its own. kShared: of one of many that do jobs of the folder. kPatient:
  // as kAlone, and waits for others, who have it for moments only.
  enum class Kind { kAlone, kShared, kPatient };

  // Throws InputError where another command has it, or where the folder cannot be written. On a
  // file system that knows no locks there is none.
  FolderLock(const std::filesystem::path& folder, Kind kind);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept
      : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  bool IsStillThere() const;

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace clothfit
