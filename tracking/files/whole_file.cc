// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/whole_file.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& file, int error) {
  throw InputError(file.string(), std::string("cannot be written: ") + std::strerror(error));
}

// A file being written; closed at the end of its scope, whatever happens.
class OpenFile {
 public:
  OpenFile(fs::path path, int flags) : path_(std::move(path)) {
    constexpr mode_t kEveryoneByMask = 0666;
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, kEveryoneByMask);
    if (descriptor_ < 0) Fail(path_, errno);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void Write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) Fail(path_, errno);
      text.remove_prefix(static_cast<size_t>(written));
    }
  }

  // Not every file can be flushed (pipes and devices cannot); whatever else fails is an error.
  void Close(bool flush) {
    if (flush && fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) Fail(path_, errno);
    const int result = close(descriptor_);
    descriptor_ = -1;
    if (result != 0) Fail(path_, errno);
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
};

}  // namespace

void WriteWholeFile(const fs::path& file, std::string_view contents) {
  fs::path part = file;
  part += ".part";
  try {
    OpenFile open_file(part, O_TRUNC);
    open_file.Write(contents);
    open_file.Close(true);
  } catch (const InputError&) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  std::error_code error;
  fs::rename(part, file, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  Fail(file, error.value());
}

void AppendLine(const fs::path& file, std::string_view line) {
  OpenFile open_file(file, O_APPEND);
  open_file.Write(std::string(line) + "\n");
  open_file.Close(false);
}

}  // namespace clothfit
