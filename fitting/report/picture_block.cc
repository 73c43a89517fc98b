// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/report_sections.h"
#include "tracking/text/text.h"

namespace clothfit {

ReportJson PictureBlock(const std::filesystem::path& file, const std::string& title,
                        ReportBlobs* blobs) {
  return {{"kind", "picture"},
          {"title", title},
          {"type", file.extension() == ".svg" ? "image/svg+xml" : "image/png"},
          {"image", blobs->AddBytes(ReadTextFile(file))}};
}

}  // namespace clothfit
