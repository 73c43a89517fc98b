// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/folder_lock.h"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

int Open(const fs::path& file) {
  const int descriptor =
      open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor >= 0) return descriptor;
  throw InputError(file.parent_path().string(),
                   "cannot be written: " + std::generic_category().message(errno));
}

constexpr int kMostTries = 100;
constexpr std::chrono::milliseconds kBetweenTries(10);

// False where somebody else has the lock. A system without locks gives it to everybody.
bool TryLock(int descriptor, int operation) {
  int result = 0;
  do {
    result = flock(descriptor, operation);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno != EWOULDBLOCK;
}

// One of many is kept out for a moment by another that ends and tidies up.
bool Lock(int descriptor, int operation) {
  for (int i = 1; !TryLock(descriptor, operation); ++i) {
    if (operation != (LOCK_SH | LOCK_NB) || i == kMostTries) return false;
    std::this_thread::sleep_for(kBetweenTries);
  }
  return true;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, Kind kind) : file_(folder / kLockFile) {
  const int operation = kind == Kind::kShared    ? LOCK_SH | LOCK_NB
                        : kind == Kind::kPatient ? LOCK_EX
                                                 : LOCK_EX | LOCK_NB;
  while (true) {
    descriptor_ = Open(file_);
    if (!Lock(descriptor_, operation)) {
      close(descriptor_);
      throw InputError(folder.string(),
                       "another clothfit is writing it; expected a folder of its own, or wait");
    }
    if (IsStillThere()) return;
    close(descriptor_);  // who had it before has removed the file meanwhile
  }
}

// The last one tidies up.
FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && IsStillThere()) unlink(file_.c_str());
  close(descriptor_);
}

bool FolderLock::IsStillThere() const {
  struct stat open_file = {}, there = {};
  return fstat(descriptor_, &open_file) == 0 && lstat(file_.c_str(), &there) == 0 &&
         open_file.st_ino == there.st_ino && open_file.st_dev == there.st_dev;
}

}  // namespace clothfit
