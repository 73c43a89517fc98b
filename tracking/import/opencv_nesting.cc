// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/opencv_nesting.h"

#include <algorithm>

namespace clothfit {
namespace {

class Levels {
 public:
  void Open() {
    ++opened_;
    OpenInLine();
  }
  // What the line's end closes for certain.
  void OpenInLine() { deepest_ = std::max(deepest_, ++depth_); }
  void Close() { depth_ = std::max(0, depth_ - 1); }
  void Indent(int columns) { deepest_ = std::max(deepest_, columns); }
  bool AreFew() const {
    constexpr int kDeepest = 100, kMost = 10'000;
    return deepest_ <= kDeepest && opened_ <= kMost;
  }

 private:
  int depth_ = 0, deepest_ = 0, opened_ = 0;
};

char FirstOf(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first == std::string_view::npos ? '\0' : text[first];
}

bool IsXml(std::string_view text) { return FirstOf(text) == '<'; }

bool IsShallowXml(std::string_view text) {
  Levels levels;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const char next = text[i + 1];
    if (text[i] == '/' && next == '>') levels.Close();
    if (text[i] != '<') continue;
    if (next == '/') levels.Close();
    if (next != '/' && next != '?' && next != '!') levels.Open();
  }
  return levels.AreFew();
}

}  // namespace

bool IsShallow(std::string_view text) {
  if (IsXml(text)) return IsShallowXml(text);
  const bool is_json = FirstOf(text) == '{';
  Levels levels;
  int column = 0;  // of this line, before all else
  int begun = 0;   // lists and maps that begin somewhere in this line
  bool is_at_begin = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n' || c == '\r') {
      for (; begun > 0; --begun) levels.Close();
      column = 0;
      is_at_begin = true;
      continue;
    }
    // A list in a list in a list (- - -), or maps (a: b: c:), all of them in one line.
    const bool is_last = i + 1 == text.size() || text[i + 1] == ' ';
    const bool is_item = c == '-' && is_last;
    if (is_item || (c == ':' && is_last && !is_json)) {
      levels.OpenInLine();
      ++begun;
    }
    is_at_begin = is_at_begin && (c == ' ' || is_item);
    if (is_at_begin) levels.Indent(++column);
    if (c == '[' || c == '{') levels.Open();
    if (c == ']' || c == '}') levels.Close();
  }
  return levels.AreFew();
}

bool HasWholeTags(std::string_view text) {
  if (!IsXml(text)) return true;
  for (std::size_t i = text.find('<'); i != std::string_view::npos; i = text.find('<', i)) {
    const bool is_comment = text.substr(i, 4) == "<!--";
    const std::size_t end = is_comment ? text.find("-->", i) : text.find_first_of("<>", i + 1);
    if (end == std::string_view::npos || text[end] == '<') return false;
    const std::string_view tag = text.substr(i, end - i);
    if (!is_comment && std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    i = end;
  }
  return true;
}

}  // namespace clothfit
