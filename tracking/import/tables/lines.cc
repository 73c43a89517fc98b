// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/tables/lines.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// A quote inside quotes is doubled.
std::vector<std::string> SplitLine(std::string_view line, char separator) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = std::string(TrimBlanks(field));
  return fields;
}

}  // namespace

TableLines::TableLines(std::filesystem::path file, std::string text)
    : file_(std::move(file)), text_(std::move(text)), rest_(text_) {
  if (StartsWith(rest_, "\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::string_view TableLines::NextLine() const { return rest_.substr(0, rest_.find('\n')); }

bool TableLines::IsEmpty(std::string_view line) const {
  return std::all_of(line.begin(), line.end(),
                     [&](char c) { return c == separator_ || c == ' ' || c == '\t' || c == '\r'; });
}

bool TableLines::IsEmptyNext() const { return IsEmpty(NextLine()); }

char TableLines::LikelySeparator() const {
  std::string_view text = rest_;
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::string_view line = text.substr(0, text.find('\n'));
  for (const char separator : {'\t', ';'}) {
    if (TrimBlanks(line).find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

bool TableLines::Next(std::vector<std::string>* fields) {
  while (!rest_.empty()) {
    const std::string_view line = NextLine();
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++number_;
    if (IsEmpty(line)) continue;
    *fields = SplitLine(line, separator_);
    return true;
  }
  return false;
}

void TableLines::Require(const std::string& expected, std::vector<std::string>* fields) {
  if (!Next(fields)) Fail("expected " + expected + ", found the end");
}

void TableLines::FailAt(int line, const std::string& problem) const {
  throw InputError(fmt::format("{}: line {}", file_.string(), line), problem);
}

void TableLines::Fail(size_t column, const std::string& problem) const {
  throw InputError(fmt::format("{}: line {}, column {}", file_.string(), number_, column + 1),
                   problem);
}

}  // namespace clothfit
