// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Includes flow one way: autodiff_sim <- tracking <- fitting <- apps.
#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/project/source_file.h"

namespace clothfit::project {
namespace {

// A folder may include itself and those before it.
const std::vector<std::string> kLayers = {"autodiff_sim", "tracking", "fitting", "apps"};

std::string FirstFolder(const std::string& path) { return path.substr(0, path.find('/')); }

int LayerOf(const std::string& path) {
  const auto layer = std::find(kLayers.begin(), kLayers.end(), FirstFolder(path));
  return layer == kLayers.end() ? -1 : static_cast<int>(layer - kLayers.begin());
}

// One line for every include of this file that points the wrong way. Quotes are for clothfit's own
// headers, which are named from the root of the project, so that no "../" can hide a direction.
std::vector<std::string> WrongIncludes(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  const int own_layer = LayerOf(file.path);
  std::vector<std::string> wrong;
  for (size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_match(file.lines[i], match, kInclude)) continue;
    const int layer = LayerOf(match[2]);
    const bool foreign = layer < 0 && match[1] == "<";
    const bool allowed = layer >= 0 && layer <= own_layer;
    if (foreign || allowed) continue;
    wrong.push_back(file.path + ":" + std::to_string(i + 1) + ": " + file.lines[i]);
  }
  return wrong;
}

TEST(IncludeDirection, EverySourcePointsDownwards) {
  int checked = 0;
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, kLayers)) {
    if (!IsCpp(file)) continue;
    ++checked;
    EXPECT_THAT(WrongIncludes(file), testing::IsEmpty());
  }
  EXPECT_GT(checked, 0);
}

TEST(IncludeDirection, AcceptsOwnLowerAndForeignHeaders) {
  const SourceFile file{"tracking/rays.cc",
                        {"#include \"tracking/rays.h\"", "#include <vector>",
                         "#include <opencv2/tracking/tracking.hpp>",
                         "#include \"autodiff_sim/mesh.h\"  // the triangles"}};
  EXPECT_THAT(WrongIncludes(file), testing::IsEmpty());
}

TEST(IncludeDirection, ReportsEveryWrongInclude) {
  const SourceFile file{
      "tracking/rays.cc",
      {"#include \"fitting/fit/fit.h\"", "#include \"autodiff_sim/mesh.h\"",
       "  #  include <apps/command.h>", "#include \"../fitting/fit.h\"", "#include \"rays.h\""}};
  EXPECT_THAT(WrongIncludes(file),
              testing::ElementsAre("tracking/rays.cc:1: #include \"fitting/fit/fit.h\"",
                                   "tracking/rays.cc:3:   #  include <apps/command.h>",
                                   "tracking/rays.cc:4: #include \"../fitting/fit.h\"",
                                   "tracking/rays.cc:5: #include \"rays.h\""));
}

TEST(IncludeDirection, EachFolderIsHeldToItsOwnLayer) {
  int wrong_pairs = 0;
  for (const std::string& from : kLayers) {
    for (const std::string& to : kLayers) {
      const SourceFile file{from + "/a.cc", {"#include \"" + to + "/b.h\""}};
      wrong_pairs += static_cast<int>(WrongIncludes(file).size());
    }
  }
  EXPECT_EQ(wrong_pairs, 3 + 2 + 1);
}

}  // namespace
}  // namespace clothfit::project
