// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/kinds.h"

#include <fstream>
#include <string>

#include "autodiff_sim/base/error.h"
#include "fitting/report/blobs.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool Has(const fs::path& folder, const char* name) { return fs::exists(folder / name); }

bool HasFileEndingIn(const fs::path& folder, const char* extension) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) return true;
  }
  return false;
}

std::string FirstLine(const fs::path& file) {
  std::ifstream text(file);
  std::string line;
  std::getline(text, line);
  return line;
}

// Whether the log of a folder is that of this command.
bool IsLogOf(const fs::path& folder, const std::string& command) {
  return FirstLine(folder / "log.txt").rfind("clothfit " + command, 0) == 0;
}

}  // namespace

FolderKind KindOfFolder(const fs::path& folder) {
  constexpr const char* kExpected =
      "expected one that 'clothfit fit', 'diagnose', 'compare', 'study' or 'trials' wrote";
  if (!fs::exists(folder)) throw InputError(folder.string(), "does not exist");
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string(), std::string("is no folder; ") + kExpected);
  }
  if (Has(folder, "diagnosis.json") || IsLogOf(folder, "diagnose")) return FolderKind::kDiagnosis;
  if (Has(folder, "summary.json") || IsLogOf(folder, "")) return FolderKind::kRun;
  const bool is_trials = Has(folder, "commitments.csv");
  if (Has(folder, "comparison.json")) return FolderKind::kComparison;
  if (Has(folder, "conditions.yaml") && !is_trials) return FolderKind::kComparison;
  if (Has(folder, "recording.yaml")) {
    throw InputError(folder.string(), std::string("is the folder of a recording; ") + kExpected);
  }
  if (is_trials || HasFileEndingIn(folder, ".md") || HasFileEndingIn(folder, ".csv")) {
    return FolderKind::kStudy;
  }
  throw InputError(folder.string(),
                   std::string("is not the folder of a run or a study; ") + kExpected);
}

namespace {

ReportPage MakeReportOfKind(const fs::path& folder, const ReportAssets& assets,
                            const ReportOptions& options) {
  switch (KindOfFolder(folder)) {
    case FolderKind::kDiagnosis:
      return MakeDiagnosisReport(folder, assets, options);
    case FolderKind::kComparison:
      return MakeComparisonReport(folder, assets);
    case FolderKind::kStudy:
      return MakeStudyReport(folder, assets);
    case FolderKind::kRun:
      break;
  }
  return MakeReport(RunFolder::Open(folder), assets, options);
}

}  // namespace

ReportPage MakeReport(const fs::path& folder, const ReportAssets& assets,
                      const ReportOptions& options) {
  try {
    return MakeReportOfKind(folder, assets, options);
  } catch (const ReportBlobs::Json::exception& error) {
    throw InputError(folder.string(),
                     std::string("is damaged, or of another version of clothfit: ") + error.what());
  }
}

}  // namespace clothfit
