// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The Markdown and the tables that clothfit's studies write, as blocks of a report: headings,
// paragraphs, lists, tables and code. What it does not know it shows as it stands.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fitting/report/page/blocks.h"

namespace clothfit {

struct MarkdownPage {
  std::string title;                    // the first heading; empty where there is none
  std::vector<std::string> paragraphs;  // prose, in order
  int paragraphs_before_table = 0;      // how many of them stand before the first table
  ReportJson blocks = ReportJson::array();
};
MarkdownPage ParseMarkdown(const std::string& text);

// The first full sentence, and what is left of the paragraph. A full stop within a number is
// followed by no blank.
std::pair<std::string, std::string> FirstSentence(const std::string& paragraph);

// The first `most` rows of comma separated values, quotes understood, as a table that can be
// sorted. Numbers are numbers. `num_rows`: how many there are. Null where the text holds no header.
ReportJson CsvTable(const std::string& text, const std::string& title, std::size_t most,
                    std::size_t* num_rows);

}  // namespace clothfit
