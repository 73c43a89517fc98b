// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A force term is one header and one line, so that few other sources name one, or its parameters.
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/project/source_file.h"

namespace clothfit::project {
namespace {

// How often "term" or "term.parameter" stands in the sources of a folder, with words such as
// "contact" that mean something else; the terms' own folder, whose kReads are checked when it is
// compiled, is left out. A number may fall. Before it rises see FullName and ValuesOf; a term's row
// for trials or its law for finite elements is a reason.
const std::map<std::string, int> kMost = {{"autodiff_sim/contact", 1},
                                          {"autodiff_sim/step", 3},
                                          {"autodiff_sim/term", 3},
                                          {"fitting/diagnosis/classify", 3},
                                          {"fitting/diagnosis/compare", 3},
                                          {"fitting/export", 1},
                                          {"fitting/report", 2},
                                          {"fitting/report/diagnosis", 1},
                                          {"fitting/report/sections", 1},
                                          {"fitting/studies", 35},
                                          {"fitting/trials", 84},
                                          {"fitting/trials/finite_elements", 59},
                                          {"fitting/trials/terms", 2},
                                          {"python", 1},
                                          {"tracking/recording/folder", 7},
                                          {"tracking/recording/warnings", 3},
                                          {"tracking/synthetic", 9}};

TEST(TermNames, StandInFewOtherSources) {
  const std::regex name_line(R"re(.* kName = "([a-z_]+)";.*)re");
  const std::regex quoted(R"re("([a-z_]+)(\.[a-z_0-9]+)?")re");
  std::set<std::string> names;
  std::smatch match;
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, {"autodiff_sim/terms"}))
    for (const std::string& line : file.lines)
      if (std::regex_match(line, match, name_line)) names.insert(match[1]);
  EXPECT_GT(names.size(), 30U);
  std::map<std::string, int> counts;
  for (const SourceFile& file :
       ReadFolders(CLOTHFIT_SOURCE_DIR,
                   {"apps", "autodiff_sim", "clothfit", "fitting", "python", "tracking"})) {
    const std::string folder = file.path.substr(0, file.path.rfind('/'));
    if (!IsCpp(file) || folder == "autodiff_sim/terms") continue;
    for (const std::string& line : file.lines) {
      if (line.find('"') == std::string::npos || std::regex_match(line, name_line)) continue;
      const std::string code = line.substr(0, line.find("//"));
      for (std::sregex_iterator i(code.begin(), code.end(), quoted), end; i != end; ++i)
        counts[folder] += names.count((*i)[1]) > 0 ? 1 : 0;
    }
  }
  for (const auto& [folder, count] : counts)
    EXPECT_LE(count, kMost.count(folder) > 0 ? kMost.at(folder) : 0) << folder;
}

}  // namespace
}  // namespace clothfit::project
