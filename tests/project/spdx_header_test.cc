// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every source begins with the two lines that name its authors and its licence.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/project/source_file.h"

namespace clothfit::project {
namespace {

const std::vector<std::string> kFolders = {".ci",   "apps",     "autodiff_sim", "clothfit",
                                           "cmake", "examples", "fitting",      "python",
                                           "tests", "tools",    "tracking"};

bool IsScript(const SourceFile& file) {
  return !file.lines.empty() && file.lines[0].rfind("#!", 0) == 0;
}

// How a comment begins in this file; empty for a file that is no source.
std::string CommentMark(const SourceFile& file) {
  if (IsCpp(file)) return "//";
  const std::filesystem::path path(file.path);
  const bool is_made = file.path.find("/dist/") != std::string::npos;  // by `make report-assets`
  const bool is_script = path.extension() == ".js" || path.extension() == ".mjs";
  if (is_script && !is_made) return "//";
  const bool is_cmake = path.filename() == "CMakeLists.txt" || path.extension() == ".cmake";
  return is_cmake || IsScript(file) ? "#" : "";
}

bool HasHeader(const SourceFile& file, const std::string& mark) {
  const size_t first = IsScript(file) ? 1 : 0;
  return file.lines.size() >= first + 2 &&
         file.lines[first] == mark + " SPDX-FileCopyrightText: 2026 The clothfit authors" &&
         file.lines[first + 1] == mark + " SPDX-License-Identifier: Apache-2.0";
}

TEST(SpdxHeader, StandsInEverySource) {
  int checked = 0;
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, kFolders)) {
    const std::string mark = CommentMark(file);
    if (mark.empty()) continue;
    ++checked;
    EXPECT_TRUE(HasHeader(file, mark)) << file.path;
  }
  EXPECT_GT(checked, 0);
}

TEST(SpdxHeader, IsMissedWhereItIsWrong) {
  const std::string authors = " SPDX-FileCopyrightText: 2026 The clothfit authors";
  const std::string licence = " SPDX-License-Identifier: Apache-2.0";
  EXPECT_TRUE(HasHeader({"a.cc", {"//" + authors, "//" + licence, "int a;"}}, "//"));
  EXPECT_TRUE(HasHeader({"a", {"#!/bin/sh", "#" + authors, "#" + licence}}, "#"));
  EXPECT_FALSE(HasHeader({"a.cc", {}}, "//"));
  EXPECT_FALSE(HasHeader({"a.cc", {"//" + authors}}, "//"));
  EXPECT_FALSE(HasHeader({"a.cc", {"//" + licence, "//" + authors}}, "//"));
  EXPECT_FALSE(HasHeader({"a.cc", {"", "//" + authors, "//" + licence}}, "//"));
}

}  // namespace
}  // namespace clothfit::project
