// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the help says of options that are left out.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "fitting/config/config.h"
#include "fitting/studies/study_options.h"
#include "tests/apps/command.h"
#include "tracking/import/take/recording.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

constexpr const char* kCommands =
    "import markers,import colmap,import opencv,import video,track,synthesize,fit,diagnose,"
    "simulate,batch,report,draw,predict,export,evaluate,compare,gradcheck,trials,job,terms,"
    "study recovery,study tracking,study chaos,study mesh,study cameras,study augmented,"
    "study attraction,study runtime,study gradients,study optimisers";

// Those that add something: where they are left out there is none of it.
constexpr const char* kNothing =
    "--config --preset --sbatch --size --ground --corner --origin --rate --frames ";

std::vector<std::string> Split(const std::string& text, char delimiter) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, delimiter);) parts.push_back(part);
  return parts;
}

std::string Help(const std::string& command) {
  const TestFolder folder;
  const CommandResult result = RunCommand(Split("help " + command, ' '), folder.path());
  EXPECT_EQ(result.status, 0) << result.err;
  return result.out;
}

// The rows of options that take a value, each as one line without its breaks.
std::vector<std::string> RowsOfValues(const std::string& help) {
  std::vector<std::string> rows;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("  -", 0) == 0) {
      rows.push_back(line.substr(2));
    } else if (line.rfind("    ", 0) == 0 && !rows.empty()) {
      rows.back() += " " + line.substr(line.find_first_not_of(' '));
    } else if (!rows.empty()) {
      rows.back() += '\n';  // no row goes on after a title
    }
  }
  const auto takes_none = [](const std::string& row) {
    const std::size_t name = row.find("--");
    const std::size_t value = row.find_first_of(" ,", name);
    return value == std::string::npos || row[value] == ',' || row.compare(value, 2, "  ") == 0;
  };
  rows.erase(std::remove_if(rows.begin(), rows.end(), takes_none), rows.end());
  return rows;
}

std::string RowOf(const std::string& command, const std::string& option) {
  for (const std::string& row : RowsOfValues(Help(command))) {
    if (row.find(option + " ") != std::string::npos) return row;
  }
  ADD_FAILURE() << command << " has no " << option;
  return "";
}

TEST(Defaults, AreToldOfEveryOption) {
  int checked = 0;
  for (const std::string& command : Split(kCommands, ',')) {
    for (const std::string& row : RowsOfValues(Help(command))) {
      const std::size_t begin = row.find("--");
      const std::string name = row.substr(begin, row.find(' ', begin) - begin + 1);
      if (std::string(kNothing).find(name) != std::string::npos) continue;
      ++checked;
      EXPECT_THAT(row, testing::ContainsRegex("\\(default: |\\(required\\)|else |left out|may be "
                                              "repeated|also |in place of|not needed"))
          << command;
    }
  }
  EXPECT_GT(checked, 150);
}

TEST(Defaults, AreThoseOfTheStructs) {
  const auto tells = [](const std::string& value) {
    return HasSubstr(fmt::format("(default: {}", value));
  };
  EXPECT_THAT(RowOf("import markers", "--every"), tells(fmt::format("{})", TakeOptions().every)));
  EXPECT_THAT(RowOf("import markers", "--held-out"), tells("0)"));
  EXPECT_THAT(RowOf("import markers", "--resolution"),
              HasSubstr(fmt::format("else {} on the longer side", kTakeParticles)));
  EXPECT_THAT(RowOf("track", "--reidentify"), tells("reference)"));
  EXPECT_THAT(RowOf("track", "--marker-place"), tells("reprojection)"));
  EXPECT_THAT(RowOf("fit", "--max-iterations"),
              tells(fmt::format("{}; {} of outlines alone)", FitConfig().max_iterations,
                                kIterationsOfOutlines)));
  EXPECT_THAT(RowOf("fit", "--loss"), tells("none; huber"));
  EXPECT_THAT(RowOf("fit", "--initial-order"), tells("-1; 0 where"));
}

TEST(Defaults, OfStudiesAreToldOfBothSizes) {
  const StudyOptions reduced, full = FullSize();
  EXPECT_THAT(RowOf("study runtime", "--frames"),
              HasSubstr(fmt::format("(default: {}, with --full {})", reduced.frames, full.frames)));
  EXPECT_THAT(RowOf("study runtime", "--under-way"),
              HasSubstr(fmt::format("(default: {})", reduced.under_way)));
  EXPECT_THAT(RowOf("study cameras", "--values"),
              HasSubstr("(default: 1,2,3,5,7, with --full 1,2,3,4,5,6,7)"));
  EXPECT_THAT(RowOf("study runtime", "--search"),
              HasSubstr(fmt::format("(default: {})", reduced.search)));
}

TEST(Defaults, OfListsStandAsTheyAreTyped) {
  EXPECT_THAT(RowOf("compare", "--contenders"), HasSubstr("(default: lm/joint,pattern/two-loop)"));
  EXPECT_THAT(RowOf("study mesh", "--particles"), HasSubstr("(default: 9 13 19 25 31)"));
}

}  // namespace
}  // namespace clothfit
