// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/kinds.h"

#include <optional>
#include <string>

#include "autodiff_sim/base/error.h"
#include "fitting/report/page/blobs.h"
#include "tracking/files/manifest.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool HasFileEndingIn(const fs::path& folder, const char* extension) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) return true;
  }
  return false;
}

ReportPage MakeReportOfKind(const fs::path& folder, const ReportAssets& assets,
                            const ReportOptions& options) {
  constexpr const char* kExpected =
      "; expected a recording, or one that 'clothfit fit', 'diagnose', 'compare', 'study' or "
      "'trials' wrote";
  if (!fs::exists(folder)) throw InputError(folder.string(), "does not exist");
  if (!fs::is_directory(folder))
    throw InputError(folder.string(), std::string("is no folder") + kExpected);
  const std::optional<FolderKind> kind = KindOfFolder(folder);
  if (kind == FolderKind::kRun) return MakeReport(RunFolder::Open(folder), assets, options);
  if (kind == FolderKind::kJointRun) return MakeJointReport(folder, assets, options);
  if (kind == FolderKind::kDiagnosis) return MakeDiagnosisReport(folder, assets, options);
  if (kind == FolderKind::kComparison) return MakeComparisonReport(folder, assets);
  if (IsRecordingFolder(folder)) return MakeRecordingReport(folder, assets, options);
  if (HasFileEndingIn(folder, ".md") || HasFileEndingIn(folder, ".csv"))
    return MakeStudyReport(folder, assets);
  throw InputError(folder.string(),
                   std::string("is not the folder of a recording, a run or a study") + kExpected);
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
