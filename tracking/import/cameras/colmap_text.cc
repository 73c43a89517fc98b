// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/colmap_text.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {

std::vector<ColmapLine> ColmapLines(std::string_view text) {
  std::vector<ColmapLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = TrimBlanks(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line[0] != '#') lines.push_back({number, line});
  }
  return lines;
}

ColmapWords::ColmapWords(const std::filesystem::path& file, const ColmapLine& line)
    : file_(file), line_(line), rest_(line.text) {}

std::string ColmapWords::Text(const char* key) {
  rest_ = TrimBlanks(rest_);
  const size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
  std::string word(rest_.substr(0, end));
  rest_.remove_prefix(end);
  if (word.empty()) Fail(fmt::format("{} is missing", key));
  return word;
}

double ColmapWords::Number(const char* key) {
  const std::string word = Text(key);
  const std::optional<double> value = ParseNumber(word);
  if (!value) Fail(fmt::format("{}: expected a finite number, found '{}'", key, word));
  return *value;
}

int ColmapWords::Integer(const char* key) {
  const std::string word = Text(key);
  const std::optional<int> value = ParseInteger(word);
  if (!value) Fail(fmt::format("{}: expected an integer, found '{}'", key, word));
  return *value;
}

std::string_view ColmapWords::Rest() const { return TrimBlanks(rest_); }

void ColmapWords::Fail(const std::string& problem) const {
  throw InputError(fmt::format("{}: line {}", file_.string(), line_.number), problem);
}

}  // namespace clothfit
