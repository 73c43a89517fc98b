// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that are whole or not there, whatever happens while they are written and whoever else
// writes them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace clothfit {

// A file under way beside its place, under a name that nobody else has: .NAME.XXXXXX.part. It is
// removed unless it is moved to its place. Throws InputError with the system's reason.
class PartFile {
 public:
  // `ending`: of the temporary name, for writers that go by it, ".mp4" for example.
  explicit PartFile(std::filesystem::path place, const std::string& ending = "");
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void MoveToPlace();
  // False where something is there already. The system sees to it that only one of many succeeds.
  bool MoveToFreePlace();

 private:
  std::filesystem::path place_, path_;
};

// Makes the folder, and those that hold it; false where it was there. Throws InputError with the
// system's reason.
bool MakeFolder(const std::filesystem::path& folder);

// A name beside the place that nobody else has.
std::filesystem::path PartName(const std::filesystem::path& place);
// The name that a part file is under way to: "a.csv" for ".a.csv.k2x90b.part"; "" for others.
std::string PlaceOfPartFile(const std::string& name);

// Writes beside the place, flushes to the disk and moves there. Of many that write the same file
// the last one's is there. Throws InputError with the system's reason (disk full, read-only, ...),
// leaving what was there before.
void WriteWholeFile(const std::filesystem::path& file, std::string_view contents);

// As WriteWholeFile; false, and nothing done, where the file exists.
bool WriteNewFile(const std::filesystem::path& file, std::string_view contents);

// Appends, in one piece unless the disk is full, not through a link. Throws InputError with the
// system's reason.
void AppendLine(const std::filesystem::path& file, std::string_view line);
void Append(const std::filesystem::path& file, std::string_view bytes);

}  // namespace clothfit
