// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What in a folder is clothfit's: .clothfit.json, which every command keeps that writes a folder.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>

namespace clothfit {

enum class FolderKind {
  kRun,
  kDiagnosis,
  kRecording,
  kExport,
  kComparison,
  kBatch,
  kTrials,
  kStudy,
  kStudyTables,
  kStudyRecordings,
  kKeptFits,
  kSlurm,
  kJointRun
};

// As a manifest has it: "run".
std::string ToString(FolderKind kind);
// For messages: "a run".
std::string InWords(FolderKind kind);

constexpr const char* kManifestFile = ".clothfit.json";

struct Manifest {
  FolderKind kind = FolderKind::kRun;
  // By the command that wrote them; relative to the folder. "runs/silk/" is a folder that has a
  // manifest of its own.
  std::map<std::string, std::set<std::string>> files;

  bool Lists(const std::string& file) const;
  std::set<std::string> All() const;
};

// The manifest of a folder, or, where it has none, what version 0.1.0 wrote there; nothing where
// that wrote nothing. Throws InputError where the manifest is damaged or of a newer version.
std::optional<Manifest> ReadManifest(const std::filesystem::path& folder);
void WriteManifest(const Manifest& manifest, const std::filesystem::path& folder);

// Nothing where the folder is not clothfit's, or not there.
std::optional<FolderKind> KindOfFolder(const std::filesystem::path& folder);
// Whoever wrote it: a person leaves no manifest.
bool IsRecordingFolder(const std::filesystem::path& folder);

// Whether it leads to a place inside of the folder that it is relative to.
bool IsInside(const std::string& file);

// The regular files below a folder whose relative path matches. Links are not followed.
std::set<std::string> FilesNamed(const std::filesystem::path& folder, const std::regex& names);

// Removes what a killed writer left of these files, which were under way, and, where `kind` is
// said, of those beside them that a folder of that kind knows by their names.
void RemovePartFiles(const std::filesystem::path& folder, const std::set<std::string>& files,
                     std::optional<FolderKind> kind = {});

// Removes what a folder's manifest lists, and the folder if nothing else is in it; otherwise it
// keeps a manifest that lists nothing. What lies behind a link, or is no regular file any more, is
// not what was written and stays.
void RemoveWrittenFolder(const std::filesystem::path& folder);
// Removes these of a folder, and the folders in it that are empty then. Throws InputError where the
// system refuses.
void RemoveWritten(const std::filesystem::path& folder, const std::set<std::string>& files);

}  // namespace clothfit
