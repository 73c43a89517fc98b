// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/manifest.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/files/earlier_version.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestFormat = "clothfit-folder/1";

// `names`: where many processes write and none can list what all of them do, the files are known by
// names that nobody else gives.
struct KindRow {
  FolderKind kind;
  const char *name, *words, *names;
};
constexpr KindRow kKinds[] = {
    {FolderKind::kRun, "run", "a run", ""},
    {FolderKind::kJointRun, "joint run", "a fit of several recordings", ""},
    {FolderKind::kDiagnosis, "diagnosis", "a diagnosis", ""},
    {FolderKind::kRecording, "recording", "a recording", ""},
    {FolderKind::kExport, "export", "an export", ""},
    {FolderKind::kComparison, "comparison", "a comparison", ""},
    {FolderKind::kBatch, "batch", "results of a batch", ""},
    {FolderKind::kTrials, "trials", "results of trials", ""},
    {FolderKind::kStudy, "study", "results of a study", ""},
    {FolderKind::kStudyTables, "study tables", "tables of a study", ""},
    {FolderKind::kStudyRecordings, "study recordings", "the recordings of studies", ""},
    {FolderKind::kKeptFits, "kept fits", "the fits of a diagnosis",
     "(forecasts-([0-9]+-)?)?[0-9a-f]{64}\\.cbor"},
    {FolderKind::kSlurm, "slurm", "what Slurm was given and wrote",
     R"((stage-[0-9]+|gather)\.sh|submitted\.json|[0-9]+(_[0-9]+)?\.log)"}};

const KindRow& RowOf(FolderKind kind) {
  return *std::find_if(std::begin(kKinds), std::end(kKinds),
                       [&](const KindRow& row) { return row.kind == kind; });
}

[[noreturn]] void FailDamaged(const fs::path& file) {
  throw InputError(file.string(), std::string("is damaged, or of a newer clothfit; expected a ") +
                                      kManifestFormat);
}

FolderKind KindNamed(const std::string& name, const fs::path& file) {
  for (const KindRow& row : kKinds)
    if (name == row.name) return row.kind;
  FailDamaged(file);
}

Manifest ParseManifest(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) FailDamaged(file);
  Manifest manifest;
  try {
    const nlohmann::json json = nlohmann::json::parse(ReadJsonText(file));
    if (json.at("format") != kManifestFormat) FailDamaged(file);
    manifest.kind = KindNamed(json.at("kind").get<std::string>(), file);
    manifest.files = json.at("files").get<std::map<std::string, std::set<std::string>>>();
  } catch (const nlohmann::json::exception&) {
    FailDamaged(file);
  }
  for (const std::string& one : manifest.All())
    if (!IsInside(one)) FailDamaged(file);
  return manifest;
}

// Whether the folders on the way are folders, and no links.
bool IsReached(const fs::path& folder, const fs::path& file) {
  fs::path way = folder;
  for (const fs::path& part : file.parent_path()) {
    std::error_code error;
    if (!part.empty()) way /= part;
    if (way != folder && !fs::is_directory(fs::symlink_status(way, error))) return false;
  }
  return true;
}

void RemoveFile(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return;
  fs::remove(file, error);
  if (error) throw InputError(file.string(), "cannot be replaced: " + error.message());
}

}  // namespace

std::string ToString(FolderKind kind) { return RowOf(kind).name; }

std::string InWords(FolderKind kind) { return RowOf(kind).words; }

bool Manifest::Lists(const std::string& file) const {
  return std::any_of(files.begin(), files.end(),
                     [&](const auto& group) { return group.second.count(file) > 0; });
}

std::set<std::string> Manifest::All() const {
  std::set<std::string> all;
  for (const auto& [command, of_command] : files) all.insert(of_command.begin(), of_command.end());
  return all;
}

std::optional<Manifest> ReadManifest(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::nullopt;
  const fs::path file = folder / kManifestFile;
  if (fs::symlink_status(file, error).type() == fs::file_type::not_found)
    return FilesOfEarlierVersion(folder);
  Manifest manifest = ParseManifest(file);
  if (const std::string names = RowOf(manifest.kind).names; !names.empty())
    manifest.files[""] = FilesNamed(folder, std::regex(names));
  return manifest;
}

void WriteManifest(const Manifest& manifest, const fs::path& folder) {
  nlohmann::json files = nlohmann::json::object();
  const bool lists = *RowOf(manifest.kind).names == '\0';
  for (const auto& [command, of_command] : manifest.files)
    if (lists) files[command] = of_command;
  const nlohmann::json json = {
      {"format", kManifestFormat}, {"kind", ToString(manifest.kind)}, {"files", files}};
  WriteWholeFile(folder / kManifestFile,
                 json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::optional<FolderKind> KindOfFolder(const fs::path& folder) {
  const std::optional<Manifest> manifest = ReadManifest(folder);
  if (!manifest) return std::nullopt;
  return manifest->kind;
}

bool IsRecordingFolder(const fs::path& folder) {
  std::error_code error;
  return KindOfFolder(folder) == FolderKind::kRecording ||
         fs::exists(folder / "recording.yaml", error);
}

bool IsInside(const std::string& file) {
  const fs::path path = file;
  return !path.empty() && path.is_relative() && file.find('\0') == std::string::npos &&
         std::none_of(path.begin(), path.end(),
                      [](const fs::path& part) { return part == ".." || part == "."; });
}

std::set<std::string> FilesNamed(const fs::path& folder, const std::regex& names) {
  std::set<std::string> found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().lexically_relative(folder).string();
    if (fs::is_regular_file(entry->symlink_status(ignored)) && std::regex_match(name, names))
      found.insert(name);
  }
  return found;
}

void RemovePartFiles(const fs::path& folder, const std::set<std::string>& files,
                     std::optional<FolderKind> kind) {
  const std::regex names(kind ? RowOf(*kind).names : "");
  std::set<std::string> folders;
  for (const std::string& file : files)
    if (IsReached(folder, file)) folders.insert(fs::path(file).parent_path().string());
  for (const std::string& one : folders) {
    std::error_code error;
    for (fs::directory_iterator entry(folder / one, error), end; !error && entry != end;
         entry.increment(error)) {
      const std::string place = PlaceOfPartFile(entry->path().filename().string());
      if (place.empty()) continue;
      const std::string file = (fs::path(one) / place).string();
      std::error_code ignored;
      if ((files.count(file) > 0 || std::regex_match(file, names)) &&
          fs::is_regular_file(entry->symlink_status(ignored)))
        fs::remove(entry->path(), ignored);
    }
  }
}

void RemoveWritten(const fs::path& folder, const std::set<std::string>& files) {
  RemovePartFiles(folder, files);
  std::set<std::string> ways;
  for (const std::string& file : files) {
    if (!IsReached(folder, file)) continue;
    if (file.back() == '/') {
      RemoveWrittenFolder(folder / fs::path(file).parent_path());
    } else {
      RemoveFile(folder / file);
    }
    for (fs::path way = fs::path(file).parent_path(); !way.empty(); way = way.parent_path())
      ways.insert(way.string());
  }
  // Of folders the inner ones come last.
  std::for_each(ways.rbegin(), ways.rend(), [&](const std::string& way) {
    std::error_code not_empty;
    fs::remove(folder / way, not_empty);
  });
}

void RemoveWrittenFolder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return;
  const std::optional<Manifest> manifest = ReadManifest(folder);
  if (!manifest) return;
  RemoveWritten(folder, manifest->All());
  fs::remove(folder / kManifestFile, error);
  fs::remove(folder, error);  // not where something is left in it
  if (error) WriteManifest({manifest->kind, {}}, folder);
}

}  // namespace clothfit
