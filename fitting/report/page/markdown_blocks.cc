// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/markdown_blocks.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Cells = std::vector<std::string>;

// Text without the marks of emphasis and code, and with links as their text.
std::string Plain(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '`' || StartsWith(text.substr(i, 2), "**")) {
      i += text[i] == '`' ? 0 : 1;
      continue;
    }
    const std::size_t middle = text[i] == '[' ? text.find("](", i) : std::string::npos;
    const std::size_t end = middle == std::string::npos ? middle : text.find(')', middle);
    if (end == std::string::npos) {
      plain += text[i];
      continue;
    }
    plain += text.substr(i + 1, middle - i - 1);
    i = end;
  }
  return plain;
}

// "| a | b |" as its cells.
Cells SplitRow(std::string line) {
  line = std::string(TrimBlanks(line));
  if (!line.empty() && line.front() == '|') line.erase(0, 1);
  if (!line.empty() && line.back() == '|') line.pop_back();
  Cells cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');)
    cells.push_back(Plain(std::string(TrimBlanks(cell))));
  return cells;
}

// "1,234", "12 %" and "-" are not numbers here: they stay as they were written.
ReportJson Value(const std::string& text) {
  if (text.empty()) return nullptr;
  if (const std::optional<double> number = ParseNumber(text)) return *number;
  return text;
}

ReportJson TableBlock(const Cells& header, const std::vector<Cells>& rows) {
  ReportJson columns = ReportJson::array(), values = ReportJson::array();
  for (std::size_t c = 0; c < header.size(); ++c) {
    const bool is_number = std::any_of(rows.begin(), rows.end(), [c](const Cells& row) {
      return c < row.size() && ParseNumber(row[c]).has_value();
    });
    columns.push_back({{"title", header[c]}, {"number", is_number}});
  }
  for (const Cells& row : rows) {
    ReportJson cells = ReportJson::array();
    for (std::size_t c = 0; c < header.size(); ++c)
      cells.push_back(c < row.size() ? Value(row[c]) : ReportJson());
    values.push_back(cells);
  }
  return {{"kind", "table"}, {"sortable", true}, {"columns", columns}, {"rows", values}};
}

bool IsRule(const std::string& line) {
  return line.find('-') != std::string::npos &&
         line.find_first_not_of("|-: \t") == std::string::npos;
}

// Goes through the lines of a page, one block at a time.
class MarkdownReader {
 public:
  explicit MarkdownReader(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      lines_.push_back(line);
    }
  }

  MarkdownPage Read() {
    while (at_ < lines_.size()) {
      const std::string line(TrimBlanks(lines_[at_]));
      if (line.empty()) {
        ++at_;
      } else if (line.front() == '#') {
        ReadHeading(line);
      } else if (StartsWith(line, "```")) {
        ReadCode();
      } else if (line.front() == '|' && at_ + 1 < lines_.size() && IsRule(lines_[at_ + 1])) {
        ReadTable();
      } else {
        ReadParagraph();
      }
    }
    return std::move(page_);
  }

 private:
  void ReadHeading(const std::string& line) {
    const std::string title =
        Plain(std::string(TrimBlanks(line.substr(line.find_first_not_of('#')))));
    ++at_;
    if (page_.title.empty() && page_.blocks.empty()) {
      page_.title = title;
    } else {
      page_.blocks.push_back({{"kind", "heading"}, {"text", title}});
    }
  }

  void ReadCode() {
    std::string text;
    for (++at_; at_ < lines_.size() && !StartsWith(lines_[at_], "```"); ++at_)
      text += lines_[at_] + "\n";
    ++at_;
    page_.blocks.push_back({{"kind", "code"}, {"text", text}});
  }

  void ReadTable() {
    const Cells header = SplitRow(lines_[at_]);
    std::vector<Cells> rows;
    for (at_ += 2; at_ < lines_.size() && StartsWith(lines_[at_], "|"); ++at_)
      rows.push_back(SplitRow(lines_[at_]));
    if (!has_table_) page_.paragraphs_before_table = static_cast<int>(page_.paragraphs.size());
    has_table_ = true;
    page_.blocks.push_back(TableBlock(header, rows));
  }

  // A list's items are paragraphs of their own.
  void ReadParagraph() {
    std::string text;
    for (; at_ < lines_.size(); ++at_) {
      std::string line(TrimBlanks(lines_[at_]));
      const bool is_item = StartsWith(line, "- ") || StartsWith(line, "* ");
      if (line.empty() || line.front() == '#' || line.front() == '|') break;
      if (is_item && !text.empty()) break;
      if (is_item) line.erase(0, 2);
      text += (text.empty() ? "" : " ") + line;
    }
    if (text.empty()) text = lines_[at_++];  // a row without a table
    page_.paragraphs.push_back(Plain(text));
    page_.blocks.push_back(TextBlock({Plain(text)}));
  }

  std::vector<std::string> lines_;
  std::size_t at_ = 0;
  bool has_table_ = false;
  MarkdownPage page_;
};

// One line of comma separated values; quotes hold commas, and "" is a quote.
Cells SplitCsv(const std::string& line) {
  Cells cells = {""};
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace

std::pair<std::string, std::string> FirstSentence(const std::string& paragraph) {
  const std::size_t stop = paragraph.find(". ");
  if (stop == std::string::npos) return {paragraph, ""};
  return {paragraph.substr(0, stop + 1), paragraph.substr(stop + 2)};
}

MarkdownPage ParseMarkdown(const std::string& text) { return MarkdownReader(text).Read(); }

ReportJson CsvTable(const std::string& text, const std::string& title, std::size_t most,
                    std::size_t* num_rows) {
  std::istringstream stream(text);
  std::string line;
  *num_rows = 0;
  if (!std::getline(stream, line) || TrimBlanks(line).empty()) return nullptr;
  const Cells header = SplitCsv(line);
  std::vector<Cells> rows;
  while (std::getline(stream, line)) {
    if (TrimBlanks(line).empty()) continue;
    if ((*num_rows)++ < most) rows.push_back(SplitCsv(line));
  }
  ReportJson table = TableBlock(header, rows);
  table["title"] = title;
  table["folded"] = true;
  return table;
}

}  // namespace clothfit
