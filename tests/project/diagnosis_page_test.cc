// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page on the diagnosis is short, and names files and rooms that are there.
#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/project/source_file.h"

namespace clothfit::project {
namespace {

SourceFile ThePage() {
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, {"docs"}))
    if (file.path == "docs/diagnosis.md") return file;
  ADD_FAILURE() << "no docs/diagnosis.md";
  return {};
}

// All that stands between single backticks.
std::set<std::string> Quoted(const SourceFile& page) {
  const std::regex in_backticks("`([^`]+)`");
  std::set<std::string> names;
  for (const std::string& line : page.lines)
    for (std::sregex_iterator i(line.begin(), line.end(), in_backticks), end; i != end; ++i)
      names.insert((*i)[1]);
  return names;
}

TEST(DiagnosisPage, IsTheMethodAlone) { EXPECT_LE(ThePage().lines.size(), 250U); }

TEST(DiagnosisPage, NamesFilesThatAreThere) {
  std::set<std::string> files;
  for (const SourceFile& file :
       ReadFolders(CLOTHFIT_SOURCE_DIR, {"autodiff_sim", "fitting", "tracking"}))
    files.insert("/" + file.path);
  int checked = 0;
  for (const std::string& name : Quoted(ThePage())) {
    if (!std::regex_match(name, std::regex(R"re([a-z_/]+\.(cc|h))re"))) continue;
    const std::string end = "/" + name;
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [&](const std::string& file) {
      return file.size() >= end.size() &&
             file.compare(file.size() - end.size(), end.size(), end) == 0;
    })) << name;
    ++checked;
  }
  EXPECT_GT(checked, 25);
}

TEST(DiagnosisPage, NamesEveryRoom) {
  const std::set<std::string> names = Quoted(ThePage());
  const std::string folder = "fitting/diagnosis/";
  std::set<std::string> rooms;
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, {"fitting/diagnosis"})) {
    const std::size_t slash = file.path.find('/', folder.size());
    if (slash != std::string::npos)
      rooms.insert(file.path.substr(folder.size(), slash - folder.size()));
  }
  EXPECT_GT(rooms.size(), 8U);
  for (const std::string& room : rooms) EXPECT_EQ(names.count(room), 1U) << room;
}

}  // namespace
}  // namespace clothfit::project
