// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of docs/model.md have what the terms say of themselves.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

std::vector<std::string> RowsOfModelPage() {
  std::ifstream page(std::string(CLOTHFIT_SOURCE_DIR) + "/docs/model.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `", 0) == 0) rows.push_back(line);
  }
  return rows;
}

// What stands between backticks.
std::vector<std::string> CodeOf(const std::string& text) {
  static const std::regex kCode("`([^`]*)`");
  return {std::sregex_token_iterator(text.begin(), text.end(), kCode, 1), {}};
}

// The terms of a row: those of its first cell before it says whose force they are a part of.
std::vector<std::string> TermsOf(const std::string& row) {
  const std::string cell = row.substr(0, row.find(" | ", 2));
  return CodeOf(cell.substr(0, cell.find(" of ")));
}

bool IsOfTerm(const std::string& row, const std::string& name) {
  const std::vector<std::string> terms = TermsOf(row);
  return std::find(terms.begin(), terms.end(), name) != terms.end();
}

TEST(ModelPage, HasEveryTermWithItsSource) {
  const std::vector<std::string> rows = RowsOfModelPage();
  ASSERT_FALSE(rows.empty());
  for (const TermInfo& term : AllTerms()) {
    const auto is_its = [&](const std::string& row) { return IsOfTerm(row, term.name); };
    ASSERT_EQ(std::count_if(rows.begin(), rows.end(), is_its), 1)
        << "expected a row: | `" << term.name << "` | (equation) | (range) | " << term.reference
        << " | `terms/(file).h` |";
    const std::string& row = *std::find_if(rows.begin(), rows.end(), is_its);
    EXPECT_NE(row.find(term.reference), std::string::npos)
        << row << "\n  has no '" << term.reference << "'";
  }
}

TEST(ModelPage, HasOnlyTermsThatThereAreAndTheirFiles) {
  const std::vector<TermInfo>& all = AllTerms();
  for (const std::string& row : RowsOfModelPage()) {
    for (const std::string& name : TermsOf(row)) {
      const auto is_it = [&](const TermInfo& term) { return term.name == name; };
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), is_it)) << "no term " << name << ": " << row;
    }
    const std::vector<std::string> files = CodeOf(row.substr(row.rfind(" | ")));
    ASSERT_FALSE(files.empty()) << row << "\n  names no file";
    const std::string file = "/autodiff_sim/" + files.front();
    EXPECT_TRUE(std::filesystem::exists(CLOTHFIT_SOURCE_DIR + file)) << "no " << file;
  }
}

}  // namespace
}  // namespace clothfit
