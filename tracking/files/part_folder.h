// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace clothfit {

// A folder under way beside its place, under a name that nobody else has, so that of many who make
// the same one none sees another's halves. Removed, with all in it, unless it is moved. Throws
// InputError with the system's reason.
class PartFolder {
 public:
  explicit PartFolder(std::filesystem::path place);
  ~PartFolder();
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // False where somebody else has put a folder there.
  bool MoveToFreePlace();
  // Removes what clothfit wrote at the place before; what else is there stays.
  void MoveToPlace();

 private:
  std::filesystem::path place_, path_;
};

}  // namespace clothfit
