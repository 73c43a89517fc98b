// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/earlier_version.h"

#include <array>
#include <fstream>
#include <functional>

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

bool HasLogOf(const fs::path& folder, const std::string& command) {
  if (!Has(folder, "log.txt")) return false;
  std::ifstream log(folder / "log.txt");
  std::array<char, 32> begin{};
  log.read(begin.data(), begin.size());
  return std::string(begin.data(), begin.size()).rfind("clothfit " + command, 0) == 0;
}

// One folder down.
bool HasSeenRecording(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (Has(entry->path(), "seen/origin.txt")) return true;
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
      {FolderKind::kDiagnosis,
       [](const fs::path& f) { return HasLogOf(f, "diagnose") || Has(f, "diagnosis.json"); },
       R"(log\.txt|config\.yaml|diagnosis\.(json|md)|report\.html|(baseline|model)\.npy|)"
       R"(missing-force(-cloth)?\.png|missing-force\.npy|fits/[0-9a-f]{64}\.cbor)"},
      {FolderKind::kRun, [](const fs::path& f) { return HasLogOf(f, ""); },
       R"((config|parameters)\.yaml|(summary|checkpoint)\.json|trajectory\.npy|mesh\.obj|)"
       R"((residuals|progress)\.csv|report\.html|log\.txt|)"
       R"(report/(obstacle_[0-9]+\.npy|obstacles\.json))"},
      {FolderKind::kTrials,
       [](const fs::path& f) { return Has(f, "commitments.csv") && HasJobs(f); },
       R"(conditions\.yaml|(commitments|trials)\.csv|trials\.md|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kComparison,
       [](const fs::path& f) {
         return Has(f, "comparison.json") || (Has(f, "conditions.yaml") && Has(f, "config.yaml"));
       },
       R"((config|conditions)\.yaml|comparison\.(json|md|svg)|(runs|history)\.csv|report\.html)"},
      {FolderKind::kBatch, [](const fs::path& f) { return Has(f, "batch.yaml") && HasJobs(f); },
       R"(batch\.(yaml|csv|md)|parameters\.csv|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kStudy, [](const fs::path& f) { return Has(f, "study.json") && HasJobs(f); },
       R"(study\.json|(attraction|augmented|cameras|local-parameters|runtime|optimisers|)"
       R"(reconstructions|gradients|gradients-differences|contact(-[a-z-]+)?))"
       R"(\.(md|csv|svg|png)|view-(side|top)\.png|jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kStudyTables,
       [](const fs::path& f) {
         return Has(f, "recovery.csv") || Has(f, "tracking.md") || Has(f, "chaos.csv");
       },
       R"((recovery|tracking|chaos)\.(md|csv|svg|png))"},
      {FolderKind::kStudyRecordings,
       [](const fs::path& f) { return HasJobs(f) && HasSeenRecording(f); },
       R"(jobs/[^/]+\.(json|lease|lost))"},
      {FolderKind::kRecording, [](const fs::path& f) { return Has(f, "truth/synthesize.yaml"); },
       synthetic.c_str()},
      {FolderKind::kRecording, [](const fs::path& f) { return Has(f, "origin.txt"); },
       tracked.c_str()}};
  return kinds;
}

}  // namespace

std::optional<Manifest> FilesOfEarlierVersion(const fs::path& folder) {
  for (const EarlierKind& earlier : EarlierKinds()) {
    if (!earlier.is_one(folder)) continue;
    Manifest manifest;
    manifest.kind = earlier.kind;
    manifest.files["clothfit 0.1.0"] = FilesNamed(folder, std::regex(earlier.names));
    return manifest;
  }
  return std::nullopt;
}

}  // namespace clothfit
