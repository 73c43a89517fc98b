// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of each kind of folder that a report can be made of.
#pragma once

#include <filesystem>

#include "fitting/report/report.h"

namespace clothfit {

// What 'clothfit diagnose' wrote. Each of these throws InputError where a file is missing, damaged
// or of another version.
ReportPage MakeDiagnosisReport(const std::filesystem::path& folder, const ReportAssets& assets,
                               const ReportOptions& options);
// What 'clothfit fit' wrote of several recordings; it leads to the pages of each.
ReportPage MakeJointReport(const std::filesystem::path& folder, const ReportAssets& assets,
                           const ReportOptions& options);
// What 'clothfit compare' wrote.
ReportPage MakeComparisonReport(const std::filesystem::path& folder, const ReportAssets& assets);
// A recording, of which nothing was fitted yet.
ReportPage MakeRecordingReport(const std::filesystem::path& folder, const ReportAssets& assets,
                               const ReportOptions& options);
// What 'clothfit study' and 'clothfit trials' wrote, or any folder of NAME.md beside tables (.csv)
// and pictures (.svg, .png).
ReportPage MakeStudyReport(const std::filesystem::path& folder, const ReportAssets& assets);

}  // namespace clothfit
