// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A page about one recording and what was simulated of it: verdict, moving cloth, sections.
#pragma once

#include <string>
#include <vector>

#include "fitting/report/report.h"
#include "fitting/report/sections/extras.h"

namespace clothfit {

struct ScenePage {
  const ReportScene& report;
  PageVerdict verdict;
  std::string title;         // of the recording
  std::string errors_title;  // what before and after mean in `errors`
  std::vector<ErrorChange> errors;
  std::vector<ScalarField> fields;  // the most telling first; at least one
  std::vector<ObstacleSurface> obstacles;
  std::vector<ReportJson> sections;  // those without blocks are left out
  ReportBlobs blobs;                 // that the sections name
  bool shows_both = false;           // the 3D view begins with both motions over each other
};
ReportPage MakeScenePage(const ScenePage& content, const ReportAssets& assets,
                         const ReportOptions& options);

// As the table beside the verdict shows them.
ReportJson ErrorsAsJson(const std::vector<ErrorChange>& changes);

// A page of any data. `json`: title, sections and what else docs/report-internals.md lists.
ReportPage AsReportPage(ReportJson json, const PageVerdict& verdict, const ReportBlobs& blobs,
                        const ReportAssets& assets);

}  // namespace clothfit
