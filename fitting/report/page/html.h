// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page around a report's data.
#pragma once

#include <string>
#include <string_view>

#include "fitting/report/page/blobs.h"
#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

// The page's own parts, made by `make report-assets`.
struct ReportAssets {
  std::string_view script, style;
};

// &, <, > and quotes as HTML wants them.
std::string EscapeHtml(std::string_view text);

// The verdict stands in the page itself and so is there before the data are, and without scripts.
std::string ReportAsHtml(const ReportBlobs::Json& json, const PageVerdict& verdict,
                         const ReportBlobs& blobs, const ReportAssets& assets);

}  // namespace clothfit
