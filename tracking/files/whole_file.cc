// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/whole_file.h"

#include <cerrno>
#include <random>
#include <regex>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kEveryoneByMask = 0666;

[[noreturn]] void Fail(const fs::path& file, int error) {
  throw InputError(file.string(), "cannot be written: " + std::generic_category().message(error));
}

// A file being written; closed at the end of its scope, whatever happens.
class OpenFile {
 public:
  // `place`: what an error names.
  OpenFile(const fs::path& path, int flags, fs::path place) : place_(std::move(place)) {
    descriptor_ =
        open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | flags,
             kEveryoneByMask);  // a pipe would wait for a reader
    if (descriptor_ < 0) Fail(place_, errno);
    struct stat status = {};
    if (fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) return;
    close(descriptor_);
    throw InputError(place_.string(), "cannot be written: is no file");
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
      if (written < 0) Fail(place_, errno);
      text.remove_prefix(static_cast<size_t>(written));
    }
  }

  // Not every file can be flushed (pipes and devices cannot); whatever else fails is an error.
  void Close(bool flush) {
    if (flush && fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) Fail(place_, errno);
    const int result = close(descriptor_);
    descriptor_ = -1;
    if (result != 0) Fail(place_, errno);
  }

 private:
  fs::path place_;
  int descriptor_ = -1;
};

std::string RandomLetters() {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::string letters;
  for (int i = 0; i < 6; ++i) letters += kLetters[random() % kLetters.size()];
  return letters;
}

void Fill(const PartFile& part, const fs::path& place, std::string_view contents) {
  OpenFile file(part.path(), 0, place);
  file.Write(contents);
  file.Close(true);
}

}  // namespace

bool MakeFolder(const fs::path& folder) {
  std::error_code error;
  const bool is_made = fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made: " + error.message());
  return is_made;
}

fs::path PartName(const fs::path& place) {
  constexpr std::size_t kLongest = 200;  // bytes of the name, so that what is added finds room
  const std::string name = place.filename().string().substr(0, kLongest);
  return place.parent_path() / ("." + name + "." + RandomLetters() + ".part");
}

PartFile::PartFile(fs::path place, const std::string& ending) : place_(std::move(place)) {
  for (int descriptor = -1; descriptor < 0;) {
    path_ = PartName(place_);
    path_ += ending;
    descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kEveryoneByMask);
    if (descriptor >= 0) {
      close(descriptor);
    } else if (errno != EEXIST) {
      Fail(place_, errno);
    }
  }
}

PartFile::~PartFile() {
  if (!path_.empty()) unlink(path_.c_str());
}

void PartFile::MoveToPlace() {
  if (rename(path_.c_str(), place_.c_str()) != 0) Fail(place_, errno);
  path_.clear();
}

bool PartFile::MoveToFreePlace() {
  if (link(path_.c_str(), place_.c_str()) == 0) return true;
  if (errno != EEXIST) Fail(place_, errno);
  return false;
}

std::string PlaceOfPartFile(const std::string& name) {
  static const std::regex kPart(R"(\.(.+)\.[a-z0-9]{6}\.part(\.[a-z0-9]+)?)");
  std::smatch match;
  return std::regex_match(name, match, kPart) ? match[1].str() : "";
}

void WriteWholeFile(const fs::path& file, std::string_view contents) {
  PartFile part(file);
  Fill(part, file, contents);
  part.MoveToPlace();
}

bool WriteNewFile(const fs::path& file, std::string_view contents) {
  PartFile part(file);
  Fill(part, file, contents);
  return part.MoveToFreePlace();
}

void AppendLine(const fs::path& file, std::string_view line) {
  Append(file, std::string(line) + "\n");
}

void Append(const fs::path& file, std::string_view bytes) {
  OpenFile open_file(file, O_APPEND, file);
  open_file.Write(bytes);
  open_file.Close(false);
}

}  // namespace clothfit
