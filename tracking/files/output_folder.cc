// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/output_folder.h"

#include <algorithm>

#include "autodiff_sim/base/error.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kImports = "import ";  // how the commands begin that add to a recording

// What a writer leaves that was killed before the folder had its first manifest.
bool IsPartOfManifest(const fs::path& file) {
  return PlaceOfPartFile(file.filename().string()) == kManifestFile;
}

// True where there is nothing, or an empty folder.
bool IsFree(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) return true;
  if (!fs::status_known(status))
    throw InputError(folder.string(), "cannot be looked at: " + error.message());
  if (!fs::is_directory(status)) throw InputError(folder.string(), "is a file; expected a folder");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename() != kLockFile && !IsPartOfManifest(entry->path())) return false;
  }
  if (error) throw InputError(folder.string(), "cannot be read: " + error.message());
  return true;
}

// A recording made by hand, or what is to become one.
bool HoldsPartsOfARecording(const fs::path& folder) {
  constexpr const char* kParts[] = {"recording.yaml", "cameras.yaml", "markers.csv", "tracks.csv",
                                    "images",         "videos",       "masks",       "background"};
  return std::any_of(std::begin(kParts), std::end(kParts), [&](const char* part) {
    std::error_code error;
    return fs::exists(folder / part, error);
  });
}

bool Adds(Existing existing) {
  return existing == Existing::kAdd || existing == Existing::kAddAndReplace;
}

FolderLock::Kind LockOf(Existing existing) {
  return existing == Existing::kJoin ? FolderLock::Kind::kPatient : FolderLock::Kind::kAlone;
}

std::string Hint(FolderKind kind) {
  const bool is_list = kind == FolderKind::kComparison || kind == FolderKind::kBatch ||
                       kind == FolderKind::kTrials || kind == FolderKind::kStudy;
  return std::string("; --force replaces it") + (is_list ? ", --resume goes on with it" : "");
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, FolderKind kind, std::string command, Existing existing)
    : path_(std::move(folder)), kind_(kind), command_(std::move(command)), existing_(existing) {
  Look();
  is_made_ = MakeFolder(path_);
  lock_.emplace(path_, LockOf(existing_));
  const std::optional<Manifest> manifest = Look();  // now that nobody else changes it
  was_there_ = manifest.has_value();
  manifest_ = manifest.value_or(Manifest{kind_, {}});
  if (existing_ == Existing::kJoin) return;  // others may be writing
  std::set<std::string> unfinished = {kManifestFile};
  const bool goes_on = existing_ == Existing::kResume;
  if (goes_on) unfinished.merge(manifest_.All());
  RemovePartFiles(path_, unfinished, goes_on ? std::optional(kind_) : std::nullopt);
}

OutputFolder::~OutputFolder() {
  lock_.reset();
  std::error_code not_empty;
  if (is_made_) fs::remove(path_, not_empty);
}

// Nothing where the folder is free, or a recording that clothfit has no part in.
std::optional<Manifest> OutputFolder::Look() const {
  if (IsFree(path_)) return std::nullopt;
  const std::optional<Manifest> manifest = ReadManifest(path_);
  if (manifest && manifest->kind == kind_) {
    if (existing_ != Existing::kRefuse) return manifest;
    throw InputError(path_.string(), "already holds " + InWords(kind_) + Hint(kind_));
  }
  if (!manifest && Adds(existing_) && HoldsPartsOfARecording(path_)) return std::nullopt;
  const std::string found = manifest ? "it holds " + InWords(manifest->kind) : "";
  if (existing_ == Existing::kRefuse) {
    throw InputError(path_.string(), "is not empty" + (manifest ? ": " + found : found) +
                                         "; expected a new or empty folder");
  }
  throw InputError(path_.string(),
                   "is not the folder of " + InWords(kind_) +
                       (manifest ? ": " + found : std::string(" that clothfit wrote")) +
                       "; nothing in it is replaced");
}

bool OutputFolder::MayReplace(const std::string& file) const {
  if (own_.count(file) > 0) return true;
  if (existing_ == Existing::kRefuse || existing_ == Existing::kAdd) return false;
  if (existing_ != Existing::kAddAndReplace) return manifest_.Lists(file);
  return std::any_of(manifest_.files.begin(), manifest_.files.end(), [&](const auto& group) {
    return StartsWith(group.first, kImports) && group.second.count(file) > 0;
  });
}

void OutputFolder::CheckMayWrite(const std::string& file) const {
  const auto fail = [&](const fs::path& place, const std::string& problem) {
    throw InputError(place.string(), problem);
  };
  if (!IsInside(file)) fail(path_ / file, "lies outside of " + path_.string());
  const fs::path relative = file;
  std::error_code error;
  fs::path way = path_;
  for (const fs::path& part : relative.parent_path()) {
    const fs::file_status status = fs::symlink_status(way /= part, error);
    if (status.type() != fs::file_type::not_found && !fs::is_directory(status))
      fail(way, "is in the way; expected a folder, and no link to one");
  }
  if (!relative.has_filename()) return;
  const fs::file_status status = fs::symlink_status(path_ / relative, error);
  if (status.type() == fs::file_type::not_found) return;
  if (MayReplace(file)) {
    if (fs::is_regular_file(status)) return;
    fail(path_ / relative, "is no regular file any more, and is not replaced");
  }
  const bool could_replace = existing_ == Existing::kAdd && manifest_.Lists(file);
  fail(path_ / relative, could_replace ? "exists already; --force replaces it"
                                       : "exists already and is not replaced, since '" + command_ +
                                             "' did not write it");
}

void OutputFolder::Unlist(const std::set<std::string>& files) {
  for (auto& [command, of_command] : manifest_.files)
    for (const std::string& file : files) of_command.erase(file);
}

void OutputFolder::Begin(const std::vector<std::string>& files) {
  for (const std::string& file : files) CheckMayWrite(file);
  std::set<std::string> old;
  if (existing_ == Existing::kReplace) old = manifest_.All();
  if (existing_ == Existing::kAddAndReplace) old = manifest_.files[command_];
  RemoveWritten(path_, old);
  Unlist(old);
  Add(files);
}

void OutputFolder::Add(const std::vector<std::string>& files) {
  for (const std::string& file : files) CheckMayWrite(file);
  Unlist({files.begin(), files.end()});
  manifest_.files[command_].insert(files.begin(), files.end());
  own_.insert(files.begin(), files.end());
  WriteManifest(manifest_, path_);
  is_made_ = false;
  std::set<fs::path> folders;
  for (const std::string& file : files) {
    // A folder with a manifest of its own is made by who writes it.
    if (file.back() != '/') folders.insert(fs::path(file).parent_path());
  }
  for (const fs::path& folder : folders) MakeFolder(path_ / folder);
}

void OutputFolder::WriteAll(const std::map<std::string, std::string>& files) const {
  for (const auto& [file, contents] : files) WriteWholeFile(path_ / file, contents);
}

void OutputFolder::Remove(const std::vector<std::string>& files) {
  std::set<std::string> listed;
  for (const std::string& file : files)
    if (manifest_.Lists(file)) listed.insert(file);
  if (listed.empty()) return;
  RemoveWritten(path_, listed);
  Unlist(listed);
  WriteManifest(manifest_, path_);
}

FolderLock OutputFolder::TakeLock() {
  FolderLock lock = std::move(*lock_);
  lock_.reset();
  return lock;
}

std::string AsFolderName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  if (name == "." || name == "..") std::replace(name.begin(), name.end(), '.', '_');
  return name.empty() ? "_" : name;
}

}  // namespace clothfit
