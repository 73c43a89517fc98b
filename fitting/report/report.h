// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A run, two of them, a diagnosis, a comparison or a study as one page that any browser opens from
// disk, without a network.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/report/page/html.h"
#include "fitting/report/scene/cameras.h"
#include "fitting/report/verdict/page_verdict.h"
#include "fitting/runs/run_folder.h"

namespace clothfit {

struct ReportOptions {
  std::filesystem::path pictures;  // a recording; empty: where the run's recording has them
  PictureSize picture;             // the largest; smaller where the page would be too large
  double max_megabytes = 24.0;     // of the whole page
  // Where the page will stand: of a fit of several recordings it leads to theirs.
  std::filesystem::path page;
};

struct ReportPage {
  std::string html;
  PageVerdict verdict;
  std::vector<std::string> notes;  // what the page says about itself, one sentence each
};

// The page of any folder that clothfit writes results into. Throws InputError where it is none, or
// is incomplete, damaged or of another version.
ReportPage MakeReport(const std::filesystem::path& folder, const ReportAssets& assets,
                      const ReportOptions& options = {});
// The page of two fits side by side, each a run or what 'clothfit diagnose' wrote; of one recording
// with both cloths in 3D. Throws InputError as above, and where both are the same.
ReportPage MakePairReport(const std::filesystem::path& folder, const std::filesystem::path& other,
                          const ReportAssets& assets, const ReportOptions& options = {});
// The page of a fit. Throws InputError where the run is incomplete or damaged, or its recording
// cannot be read.
ReportPage MakeReport(const RunFolder& run, const ReportAssets& assets,
                      const ReportOptions& options = {});

}  // namespace clothfit
