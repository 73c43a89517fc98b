// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/blocks.h"

#include <utility>

#include "tracking/text/text.h"

namespace clothfit {

ReportJson TextBlock(const std::vector<std::string>& paragraphs) {
  return {{"kind", "text"}, {"paragraphs", paragraphs}};
}

ReportJson PictureBlock(const std::filesystem::path& file, const std::string& title,
                        ReportBlobs* blobs) {
  return {{"kind", "picture"},
          {"title", title},
          {"type", file.extension() == ".svg" ? "image/svg+xml" : "image/png"},
          {"image", blobs->AddBytes(ReadTextFile(file))}};
}

ReportJson SectionOf(const std::string& id, const std::string& title, ReportJson blocks,
                     const std::string& brief) {
  ReportJson section = {{"id", id}, {"title", title}, {"blocks", std::move(blocks)}};
  if (!brief.empty()) section["short"] = brief;
  return section;
}

}  // namespace clothfit
