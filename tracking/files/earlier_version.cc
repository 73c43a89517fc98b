// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/earlier_version.h"

#include <cstring>
#include <fstream>
#include <functional>
#include <initializer_list>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// One of whose files begin as `is_one` tells, and match `names`.
struct EarlierKind {
  FolderKind kind;
  std::function<bool(const fs::path&)> is_one;
  const char* names;
};

bool Has(const fs::path& folder, const char* name) {
  std::error_code error;
  return fs::is_regular_file(folder / name, error);
}

bool HasJobs(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "jobs", error);
}

// Whether a file begins with the first of these, and goes on with the others in turn.
bool Reads(const fs::path& file, std::initializer_list<const char*> parts) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  constexpr std::size_t kMost = 65536;
  std::string text(kMost, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), kMost);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (!StartsWith(text, *parts.begin())) return false;
  std::size_t at = 0;
  for (const char* part : parts) {
    at = text.find(part, at);
    if (at == std::string::npos) return false;
    at += std::strlen(part);
  }
  return true;
}

bool IsResultOfJob(const fs::path& file) { return Reads(file, {"{\n \"output\": "}); }

bool HasResultOfJob(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder / "jobs", error), end; !error && entry != end;
       entry.increment(error)) {
    if (IsResultOfJob(entry->path())) return true;
  }
  return false;
}

// It copied the list, and put a comment for each fit after it.
bool IsBatch(const fs::path& folder) {
  return Reads(folder / "batch.yaml", {"", "fits:", "\n# ", ": "}) && HasResultOfJob(folder);
}

bool IsComparison(const fs::path& folder) {
  return Reads(folder / "comparison.json", {"{", "\"format\": \"clothfit-comparison/"}) ||
         (Reads(folder / "conditions.yaml", {"spread: ", "\nseed: ", "\nmax_simulations: "}) &&
          Has(folder, "config.yaml"));
}

bool IsDiagnosis(const fs::path& folder) {
  return Reads(folder / "log.txt", {"clothfit diagnose\n"}) ||
         Reads(folder / "diagnosis.json", {"{", "\"format\": \"clothfit-diagnosis/"});
}

bool IsStudy(const fs::path& folder) {
  return Reads(folder / "study.json", {"{\n \"clothfit\": ", "\"options\": ", "\"study\": "}) &&
         HasJobs(folder);
}

bool IsTracked(const fs::path& folder) {
  return Reads(folder / "origin.txt", {"/", "\n"}) &&
         Reads(folder / "pictures.csv", {"frame,camera,mask_quality,features,points\n"});
}

// One folder down.
bool HasSeenRecording(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (IsTracked(entry->path() / "seen")) return true;
  }
  return false;
}

constexpr const char* kRecordingNames =
    R"(recording\.yaml|(cameras\.yaml|markers\.csv|tracks\.csv|initial\.csv)|)"
    R"((handles|obstacles)/[^/]+\.csv|)";

const std::vector<EarlierKind>& EarlierKinds() {
  static const std::string tracked =
      std::string(kRecordingNames) +
      R"((pictures|filters)\.csv|origin\.txt|masks/[^/]+/[0-9]{6}\.png)";
  static const std::string synthetic =
      std::string(kRecordingNames) +
      R"(truth/(points\.csv|parameters\.yaml|synthesize\.yaml)|truth/masks/[^/]+/[0-9]{6}\.png|)"
      R"(images/[^/]+/[0-9]{6}\.png|videos/[^/]+\.(mkv|mp4|avi)|background/[^/]+\.png)";
  static const std::vector<EarlierKind> kinds = {
      {FolderKind::kDiagnosis, IsDiagnosis,
       R"(log\.txt|config\.yaml|diagnosis\.(json|md)|report\.html|(baseline|model)\.npy|)"
       R"(missing-force(-cloth)?\.png|missing-force\.npy|fits/[0-9a-f]{64}\.cbor)"},
      {FolderKind::kRun, [](const fs::path& f) { return Reads(f / "log.txt", {"clothfit 0."}); },
       R"((config|parameters)\.yaml|(summary|checkpoint)\.json|trajectory\.npy|mesh\.obj|)"
       R"((residuals|progress)\.csv|report\.html|log\.txt|)"
       R"(report/(obstacle_[0-9]+\.npy|obstacles\.json))"},
      {FolderKind::kTrials,
       [](const fs::path& f) {
         return Reads(f / "commitments.csv", {"trial,sha256\n"}) && HasJobs(f);
       },
       R"(conditions\.yaml|(commitments|trials)\.csv|trials\.md|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kComparison, IsComparison,
       R"((config|conditions)\.yaml|comparison\.(json|md|svg)|(runs|history)\.csv|report\.html)"},
      {FolderKind::kBatch, IsBatch,
       R"(batch\.(yaml|csv|md)|parameters\.csv|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kStudy, IsStudy,
       R"(study\.json|(attraction|augmented|cameras|local-parameters|runtime|optimisers|)"
       R"(reconstructions|gradients|gradients-differences|contact(-[a-z-]+)?))"
       R"(\.(md|csv|svg|png)|view-(side|top)\.png|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kStudyTables,
       [](const fs::path& f) {
         return Reads(f / "recovery.csv", {"seed,status,parameter,unit,truth,start,estimate,"});
       },
       R"(recovery\.(md|csv))"},
      {FolderKind::kStudyTables,
       [](const fs::path& f) {
         return Reads(f / "tracking.md", {"| recording | silhouette IoU (worst picture) |"});
       },
       R"(tracking\.(md|csv))"},
      {FolderKind::kStudyTables,
       [](const fs::path& f) {
         return Reads(f / "chaos.csv", {"time,rms,largest,sensitivity,predicted,growth\n"});
       },
       R"(chaos\.(md|csv|svg|png))"},
      {FolderKind::kStudyRecordings,
       [](const fs::path& f) { return HasJobs(f) && HasSeenRecording(f); },
       R"(jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kRecording,
       [](const fs::path& f) { return Reads(f / "truth/synthesize.yaml", {"scenario: "}); },
       synthetic.c_str()},
      {FolderKind::kRecording, IsTracked, tracked.c_str()}};
  return kinds;
}

// Of a name that others give, too, and not as this version wrote it.
bool IsForeign(const fs::path& folder, const std::string& file) {
  if (file == "report.html")
    return !Reads(folder / file, {"<!doctype html>", "name=\"generator\" content=\"clothfit "});
  return fs::path(file).parent_path() == "jobs" && fs::path(file).extension() == ".json" &&
         !IsResultOfJob(folder / file);
}

}  // namespace

std::optional<Manifest> FilesOfEarlierVersion(const fs::path& folder) {
  std::optional<Manifest> manifest;
  for (const EarlierKind& earlier : EarlierKinds()) {
    if (manifest && manifest->kind != earlier.kind) continue;
    if (!earlier.is_one(folder)) continue;
    if (!manifest) manifest = Manifest{earlier.kind, {}};
    for (const std::string& file : FilesNamed(folder, std::regex(earlier.names)))
      if (!IsForeign(folder, file)) manifest->files["clothfit 0.1.0"].insert(file);
  }
  return manifest;
}

}  // namespace clothfit
