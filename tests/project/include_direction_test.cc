// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Includes flow one way: autodiff_sim <- tracking <- fitting <- apps <- clothfit, and inside each
// of these and of their rooms that have rooms themselves from floor to floor. The page on the
// architecture names every room.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/project/source_file.h"

namespace clothfit::project {
namespace {

// A floor is one or more rooms; a room may include itself and the floors before its own.
using Floors = std::vector<std::set<std::string>>;

// By folder; "" is the project's own. A room "" has the folder's files that lie in no room.
const std::map<std::string, Floors> kRooms = {
    {"",
     {{"autodiff_sim"}, {"tracking"}, {"fitting"}, {"apps"}, {"clothfit"}, {"python", "examples"}}},
    {"apps",
     {{"launcher", "report"},
      {"command_line", "terminal"},
      {"process"},
      {"options"},
      {"commands"},
      {""}}},
    {"apps/commands",
     {{""}, {"jobs", "recordings", "reference", "results"}, {"fits", "measurements"}}},
    {"autodiff_sim",
     {{"base"}, {"linear", "mesh"}, {"contact"}, {"term"}, {"terms"}, {"step"}, {"scenes"}}},
    {"tracking",
     {{"text"},
      {"files"},
      {"camera"},
      {"silhouette"},
      {"recording"},
      {"outliers"},
      {"features", "import", "synthetic"}}},
    {"tracking/recording", {{""}, {"pictures", "surface"}, {"clouds"}, {"folder", "warnings"}}},
    {"tracking/import", {{"cameras", "markers", "pictures"}, {"c3d", "tables"}, {"take"}}},
    {"fitting",
     {{"files"},
      {"optimise"},
      {"config", "jobs"},
      {"scene"},
      {"residuals"},
      {"rollout"},
      {"fit"},
      {"runs"},
      {"batch", "pictures"},
      {"export", "studies"},
      {"diagnosis", "report"},
      {"trials"}}},
    {"fitting/diagnosis",
     {{"fitted"},
      {"evidence"},
      {"gate"},
      {"locate"},
      {"rank"},
      {"classify"},
      {"model"},
      {"validate"},
      {"compare"},
      {"law"},
      {"answer"},
      {"pipeline"}}},
    {"fitting/report",
     {{"records"},
      {"verdict"},
      {"page"},
      {"scene"},
      {"fields"},
      {"sections"},
      {"diagnosis", "pair"},
      {""}}},
    {"fitting/trials", {{"terms", "finite_elements"}, {""}}},
};
const Floors& kLayers = kRooms.at("");

// The nth folder of a path, "" where it has no more.
std::string FolderOf(const std::string& path, int n) {
  std::size_t begin = 0;
  for (int i = 0; i < n; ++i) {
    begin = path.find('/', begin);
    if (begin == std::string::npos) return "";
    ++begin;
  }
  const std::size_t end = path.find('/', begin);
  return end == std::string::npos ? "" : path.substr(begin, end - begin);
}

int FloorOf(const Floors& floors, const std::string& room) {
  const auto floor =
      std::find_if(floors.begin(), floors.end(),
                   [&](const std::set<std::string>& f) { return f.count(room) > 0; });
  return floor == floors.end() ? -1 : static_cast<int>(floor - floors.begin());
}

bool MayInclude(const Floors& floors, const std::string& own, const std::string& other) {
  const int floor = FloorOf(floors, other);
  return floor >= 0 && (own == other || floor < FloorOf(floors, own));
}

bool MayInclude(const std::string& own, const std::string& other) {
  std::string folder;
  for (int level = 0; kRooms.count(folder) > 0; ++level) {
    const std::string room = FolderOf(own, level);
    if (!MayInclude(kRooms.at(folder), room, FolderOf(other, level))) return false;
    if (room != FolderOf(other, level)) return true;
    folder += (folder.empty() ? "" : "/") + room;
  }
  return true;
}

// One line for every include of this file that points the wrong way. Quotes are for clothfit's own
// headers, which are named from the root of the project, so that no "../" can hide a direction.
std::vector<std::string> WrongIncludes(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  std::vector<std::string> wrong;
  for (size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_match(file.lines[i], match, kInclude)) continue;
    const bool foreign = match[1] == "<" && FloorOf(kLayers, FolderOf(match[2], 0)) < 0;
    if (foreign || MayInclude(file.path, match[2])) continue;
    wrong.push_back(file.path + ":" + std::to_string(i + 1) + ": " + file.lines[i]);
  }
  return wrong;
}

std::vector<std::string> Layers() {
  std::vector<std::string> layers;
  for (const std::set<std::string>& floor : kLayers)
    layers.insert(layers.end(), floor.begin(), floor.end());
  return layers;
}

TEST(IncludeDirection, EverySourcePointsDownwards) {
  int checked = 0;
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, Layers())) {
    if (!IsCpp(file)) continue;
    ++checked;
    EXPECT_THAT(WrongIncludes(file), testing::IsEmpty());
  }
  EXPECT_GT(checked, 0);
}

TEST(IncludeDirection, EverySourceHasARoom) {
  for (const SourceFile& file : ReadFolders(CLOTHFIT_SOURCE_DIR, Layers())) {
    if (!IsCpp(file)) continue;
    std::string folder;
    for (int level = 0; kRooms.count(folder) > 0; ++level) {
      const std::string room = FolderOf(file.path, level);
      ASSERT_GE(FloorOf(kRooms.at(folder), room), 0) << file.path;
      folder += (folder.empty() ? "" : "/") + room;
    }
  }
}

TEST(IncludeDirection, AcceptsOwnLowerAndForeignHeaders) {
  const SourceFile file{
      "tracking/camera/rays.cc",
      {"#include \"tracking/camera/rays.h\"", "#include <vector>",
       "#include <opencv2/tracking/tracking.hpp>", "#include \"tracking/text/csv.h\"",
       "#include \"autodiff_sim/scenes/scene.h\"  // the triangles"}};
  EXPECT_THAT(WrongIncludes(file), testing::IsEmpty());
}

TEST(IncludeDirection, HoldsRoomsInsideRooms) {
  const SourceFile file{
      "fitting/diagnosis/rank/ranking.cc",
      {"#include \"fitting/diagnosis/rank/ranking.h\"",
       "#include \"fitting/diagnosis/gate/gate.h\"", "#include \"fitting/runs/folder.h\"",
       "#include \"fitting/diagnosis/answer/verdict.h\"", "#include \"fitting/diagnosis/gate.h\"",
       "#include \"fitting/trials/plan.h\""}};
  EXPECT_THAT(
      WrongIncludes(file),
      testing::ElementsAre(
          "fitting/diagnosis/rank/ranking.cc:4: #include \"fitting/diagnosis/answer/verdict.h\"",
          "fitting/diagnosis/rank/ranking.cc:5: #include \"fitting/diagnosis/gate.h\"",
          "fitting/diagnosis/rank/ranking.cc:6: #include \"fitting/trials/plan.h\""));
}

TEST(IncludeDirection, ReportsEveryWrongInclude) {
  const SourceFile file{"tracking/features/rays.cc",
                        {"#include \"fitting/fit/fit.h\"", "#include \"autodiff_sim/mesh/mesh.h\"",
                         "  #  include <apps/command.h>", "#include \"../fitting/fit.h\"",
                         "#include \"rays.h\"", "#include \"tracking/import/cameras/colmap.h\""}};
  EXPECT_THAT(WrongIncludes(file),
              testing::ElementsAre(
                  "tracking/features/rays.cc:1: #include \"fitting/fit/fit.h\"",
                  "tracking/features/rays.cc:3:   #  include <apps/command.h>",
                  "tracking/features/rays.cc:4: #include \"../fitting/fit.h\"",
                  "tracking/features/rays.cc:5: #include \"rays.h\"",
                  "tracking/features/rays.cc:6: #include \"tracking/import/cameras/colmap.h\""));
}

// The words of a page in the first columns of its picture, and the folders that it quotes.
std::set<std::string> RoomsNamedIn(const std::vector<std::string>& page) {
  constexpr std::size_t kRoomColumns = 46;  // descriptions begin there
  static const std::regex kWord("[a-z_0-9]+"), kQuoted("`([a-z_]+/)*([a-z_0-9]+)/`");
  const std::sregex_iterator end;
  std::set<std::string> rooms;
  for (const std::string& line : page) {
    const std::string picture = line.rfind("    ", 0) == 0 ? line.substr(0, kRoomColumns) : "";
    for (std::sregex_iterator i(picture.begin(), picture.end(), kWord); i != end; ++i)
      rooms.insert(i->str());
    for (std::sregex_iterator i(line.begin(), line.end(), kQuoted); i != end; ++i)
      rooms.insert(i->str(2));
  }
  return rooms;
}

TEST(IncludeDirection, ThePageNamesEveryRoom) {
  const std::vector<SourceFile> docs = ReadFolders(CLOTHFIT_SOURCE_DIR, {"docs"});
  const auto page = std::find_if(docs.begin(), docs.end(), [](const SourceFile& file) {
    return file.path == "docs/architecture.md";
  });
  ASSERT_NE(page, docs.end());
  const std::set<std::string> named = RoomsNamedIn(page->lines);
  for (const auto& [folder, floors] : kRooms) {
    for (const std::set<std::string>& floor : floors) {
      for (const std::string& room : floor)
        EXPECT_TRUE(room.empty() || named.count(room) > 0) << folder << "/" << room;
    }
  }
  EXPECT_EQ(RoomsNamedIn({"    tracking   files", "of `fitting/runs/`, not `step.h` or law"}),
            (std::set<std::string>{"tracking", "files", "runs"}));
}

// Of any two rooms of a folder at most one may include the other.
TEST(IncludeDirection, EachRoomIsHeldToItsOwnFloor) {
  int pairs = 0;
  for (const auto& [layer, floors] : kRooms) {
    for (const std::set<std::string>& floor : floors) {
      for (const std::string& room : floor) {
        for (const std::set<std::string>& other_floor : floors) {
          for (const std::string& other : other_floor) {
            if (room == other) continue;
            ++pairs;
            EXPECT_FALSE(MayInclude(floors, room, other) && MayInclude(floors, other, room));
            EXPECT_EQ(MayInclude(floors, room, other) || MayInclude(floors, other, room),
                      floor != other_floor);
          }
        }
      }
    }
  }
  EXPECT_GT(pairs, 0);
  EXPECT_TRUE(MayInclude(kLayers, "apps", "autodiff_sim"));
  EXPECT_FALSE(MayInclude(kLayers, "autodiff_sim", "tracking"));
}

}  // namespace
}  // namespace clothfit::project
