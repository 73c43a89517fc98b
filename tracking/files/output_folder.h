// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A folder that a command writes, and what in it is that command's to replace.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tracking/files/folder_lock.h"
#include "tracking/files/manifest.h"
#include "tracking/files/output_file.h"

namespace clothfit {

// What to do where something of clothfit's is there already.
enum class Existing {
  kRefuse,
  kReplace,  // remove what the manifest lists, and nothing else
  kResume,   // go on with it, or begin where there is nothing
  // Put more files into a recording, be it clothfit's or made by hand, and replace none; or only
  // those that an import wrote.
  kAdd,
  kAddAndReplace,
  kJoin  // as kResume, in a folder that others use for moments, too
};

// As the options of a command say.
inline Existing ExistingIf(bool force, bool resume = false) {
  return resume ? Existing::kResume : force ? Existing::kReplace : Existing::kRefuse;
}
inline Existing ExistingIf(Overwrite overwrite) {
  return ExistingIf(overwrite == Overwrite::kAllow);
}

// Holds the folder's lock as long as it lives. Files are listed in the manifest before they are
// written, by whatever function, so that nothing of clothfit's is ever unlisted. Every problem is
// an InputError that names the folder or the file.
class OutputFolder {
 public:
  // Makes the folder, and refuses one that holds something else: another kind of folder, one that
  // clothfit did not write, one of the kind where that is to be refused. Nothing in it is changed.
  // `command`: under which the files are listed.
  OutputFolder(std::filesystem::path folder, FolderKind kind, std::string command,
               Existing existing);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Whether something was there to resume, or to replace.
  bool was_there() const { return was_there_; }

  // Begins to write these files: removes what is to be replaced, and then as Add. All is checked
  // before anything is removed. "NAME/" is a folder with a manifest of its own.
  void Begin(const std::vector<std::string>& files);
  // Lists these files and makes the folders for them. Refuses where somebody else's file, a link or
  // a folder is in the place of one.
  void Add(const std::vector<std::string>& files);
  // Writes listed files, each whole or not at all: contents by name.
  void WriteAll(const std::map<std::string, std::string>& files) const;
  // Throws InputError where Add would.
  void CheckMayWrite(const std::string& file) const;
  // Removes files that are listed, and lists them no more.
  void Remove(const std::vector<std::string>& files);
  bool Lists(const std::string& file) const { return manifest_.Lists(file); }

  // The lock alone, for when all is listed.
  FolderLock TakeLock();

 private:
  std::optional<Manifest> Look() const;
  bool MayReplace(const std::string& file) const;
  void Unlist(const std::set<std::string>& files);

  std::filesystem::path path_;
  FolderKind kind_;
  std::string command_;
  Existing existing_;
  bool is_made_ = false;  // by this, and nothing written yet
  bool was_there_ = false;
  Manifest manifest_;
  std::set<std::string> own_;  // listed since this was made
  std::optional<FolderLock> lock_;
};

template <class Value>
std::vector<std::string> NamesOf(const std::map<std::string, Value>& files) {
  std::vector<std::string> names;
  for (const auto& [name, value] : files) names.push_back(name);
  return names;
}

// The name as that of one folder: without '/', and no way up or nowhere.
std::string AsFolderName(std::string name);

}  // namespace clothfit
