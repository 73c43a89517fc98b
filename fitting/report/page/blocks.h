// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The blocks of a report's sections, as data: docs/report-internals.md has the schema of each kind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/report/page/blobs.h"

namespace clothfit {

using ReportJson = ReportBlobs::Json;

ReportJson TextBlock(const std::vector<std::string>& paragraphs);
// A file in SVG or PNG, as it is.
ReportJson PictureBlock(const std::filesystem::path& file, const std::string& title,
                        ReportBlobs* blobs);
// `brief`: the title where there is little room.
ReportJson SectionOf(const std::string& id, const std::string& title, ReportJson blocks,
                     const std::string& brief = "");

}  // namespace clothfit
