// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/storage_xml.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"

namespace clothfit {
namespace {

constexpr std::string_view kXmlSpace = " \t\r\n";

class StorageXml {
 public:
  StorageXml(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  YAML::Node Read() {
    YAML::Node root(YAML::NodeType::Map);
    const std::string tag = NextTag(nullptr);
    if (!IsEmpty(tag)) ReadContent(NameOf(tag), 1, root);
    return root;
  }

 private:
  // Up to the end of the element, whose start has been read.
  void ReadContent(const std::string& name, int depth, YAML::Node node) {
    constexpr int kDeepest = 100;
    if (depth > kDeepest) Fail("is nested too deep");
    std::string content;
    std::string tag = NextTag(&content);
    for (; tag.front() != '/'; tag = NextTag(&content)) {
      const std::string child_name = NameOf(tag);
      if ((child_name == "_") != node.IsSequence() && !node.IsNull())
        Fail("expected elements named '_' or others, found both in " + Quoted(name));
      YAML::Node child(YAML::NodeType::Null);  // which is there, so that its parent shares it
      if (child_name == "_") {
        node.push_back(child);
      } else {
        node.force_insert(child_name, child);  // unlike [], looks for no earlier one
      }
      if (!IsEmpty(tag)) ReadContent(child_name, depth + 1, child);
    }
    if (NameOf(tag.substr(1)) != name)
      Fail(fmt::format("expected the end of {}, found that of {}", Quoted(name),
                       Quoted(NameOf(tag.substr(1)))));
    const bool is_blank = content.find_first_not_of(kXmlSpace) == std::string::npos;
    if (!node.IsNull() && !is_blank)
      Fail("expected text or elements, found both in " + Quoted(name));
    if (node.IsNull()) node = content;
  }

  // What stands between the next < and >, the text before it appended to content; without comments
  // and declarations.
  std::string NextTag(std::string* content) {
    for (;;) {
      const std::size_t begin = text_.find('<', at_);
      if (begin == std::string_view::npos) Fail("expected another tag, found the end");
      if (content != nullptr) content->append(text_.substr(at_, begin - at_));
      const bool is_comment = text_.compare(begin, 4, "<!--") == 0;
      const std::size_t end =
          is_comment ? text_.find("-->", begin) : text_.find_first_of("<>", begin + 1);
      at_ = begin;
      if (end == std::string_view::npos || text_[end] == '<') Fail("has a tag that does not end");
      at_ = end + (is_comment ? 3 : 1);
      const std::string_view tag = text_.substr(begin + 1, end - begin - 1);
      if (tag.empty()) Fail("has a tag without a name");
      if (tag.front() != '?' && tag.front() != '!') return std::string(tag);
    }
  }

  static bool IsEmpty(const std::string& tag) { return tag.back() == '/'; }

  static std::string NameOf(const std::string& tag) {
    return tag.substr(0, tag.find_first_of(" \t\r\n/"));
  }

  [[noreturn]] void Fail(const std::string& problem) const {
    const std::string_view before = text_.substr(0, at_);
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 where there is none
    throw InputError(
        fmt::format("{}: line {}: column {}", file_,
                    std::count(before.begin(), before.end(), '\n') + 1, at_ - line_begin + 1),
        problem);
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
};

}  // namespace

YAML::Node ReadStorageXml(std::string_view text, const std::string& file) {
  return StorageXml(text, file).Read();
}

}  // namespace clothfit
