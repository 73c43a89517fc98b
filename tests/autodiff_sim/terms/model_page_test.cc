// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of docs/model.md have what the terms say of themselves.
#include <algorithm>
#include <fstream>
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

// Whether a row's first cell names the term before it says whose force it is a part of.
bool IsOfTerm(const std::string& row, const std::string& name) {
  const std::string cell = row.substr(0, row.find(" | ", 2));
  return cell.substr(0, cell.find(" of ")).find("`" + name + "`") != std::string::npos;
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

}  // namespace
}  // namespace clothfit
