// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/input_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& file, int error) {
  if (error == ENOENT) throw InputError(file.string(), "no such file");
  throw InputError(file.string(), "cannot be read: " + std::generic_category().message(error));
}

const char* KindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

// An open file; closed at the end of its scope.
class OpenInput {
 public:
  OpenInput(const fs::path& file, std::size_t most_bytes) : file_(file) {
    // Without waiting: opening a pipe would last until somebody writes it.
    descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0 && errno == ENXIO)
      throw InputError(file.string(), "is a socket or a device; expected a file");
    if (descriptor_ < 0) Fail(file, errno);
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) FailClosing(errno);
    if (!S_ISREG(status.st_mode)) {
      close(descriptor_);
      throw InputError(file.string(),
                       std::string("is ") + KindOf(status.st_mode) + "; expected a file");
    }
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ > most_bytes) {
      close(descriptor_);
      throw InputError(file.string(), "has " + std::to_string(size_) + " bytes; expected at most " +
                                          std::to_string(most_bytes));
    }
  }
  ~OpenInput() { close(descriptor_); }
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;

  std::string ReadAll() const {
    std::string bytes(size_, '\0');
    std::size_t have = 0;
    while (have < size_) {
      const ssize_t got = read(descriptor_, &bytes[have], size_ - have);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) Fail(file_, errno);
      if (got == 0) break;  // it became shorter meanwhile
      have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
  }

 private:
  [[noreturn]] void FailClosing(int error) const {
    close(descriptor_);
    Fail(file_, error);
  }

  const fs::path& file_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

}  // namespace

bool IsThere(const fs::path& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) == 0) return true;
  if (errno == ENOENT || errno == ENOTDIR) return false;
  Fail(path, errno);
}

void CheckInputFile(const fs::path& file, std::size_t most_bytes) { OpenInput(file, most_bytes); }

void CheckInputFolder(const fs::path& folder) {
  struct stat status = {};
  if (stat(folder.c_str(), &status) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) throw InputError(folder.string(), "no such folder");
    Fail(folder, errno);
  }
  if (!S_ISDIR(status.st_mode)) throw InputError(folder.string(), "expected a folder");
}

std::string ReadInputFile(const fs::path& file, std::size_t most_bytes) {
  return OpenInput(file, most_bytes).ReadAll();
}

std::vector<fs::path> ListInputFolder(const fs::path& folder) {
  CheckInputFolder(folder);
  std::vector<fs::path> entries;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().front() != '.') entries.push_back(entry->path());
  }
  if (error) throw InputError(folder.string(), "cannot be read: " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace clothfit
