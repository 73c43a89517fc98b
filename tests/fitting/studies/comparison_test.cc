// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "fitting/pictures/line_chart.h"
#include "tests/support/silhouette_scene.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ComparedRun MakeRun(const std::string& contender, int start, std::vector<SearchPoint> history) {
  ComparedRun run;
  run.contender = contender;
  run.start = start;
  run.history = std::move(history);
  run.error = run.open_loop_error = run.history.back().error;
  run.simulations = run.history.back().simulations + 1.0;
  run.seconds = run.history.back().seconds + 1.0;
  run.reason = "told to";
  return run;
}

// lm reaches where pattern ends ten times sooner in simulations and five times in seconds.
Comparison MakeComparison() {
  Comparison comparison;
  comparison.recording = "made";
  comparison.derivative_cost = 1.5;
  comparison.contenders = {"lm/joint", "pattern/joint"};
  comparison.runs = {MakeRun("lm/joint", 0, {{1, 1, 900}, {30, 40, 290}, {60, 70, 100}}),
                     MakeRun("pattern/joint", 0, {{1, 1, 900}, {300, 200, 300}})};
  comparison.runs[0].truth_rms = 0.0021;
  return comparison;
}

TEST(Contender, IsReadFromItsName) {
  EXPECT_EQ(ParseContender("x", "pattern/two-loop").name(), "pattern/two-loop");
  EXPECT_EQ(ParseContender("x", "lm").name(), "lm/joint");
  EXPECT_THROW(ParseContender("x", "newton"), InputError);
  EXPECT_THROW(ParseContender("x", "lm/three-loop"), InputError);
}

TEST(Comparison, StartsAreTheConfigsAndMovedOnes) {
  const SilhouetteScene known = MakeSilhouetteScene();
  ComparisonOptions options;
  EXPECT_TRUE(ConfigDifferences(StartOf(known.config, options, 0), known.config).empty());
  const FitConfig moved = StartOf(known.config, options, 1);
  EXPECT_FALSE(ConfigDifferences(moved, known.config).empty());
  EXPECT_TRUE(ConfigDifferences(StartOf(known.config, options, 1), moved).empty());
  EXPECT_FALSE(ConfigDifferences(StartOf(known.config, options, 2), moved).empty());
  for (const auto& [name, setting] : moved.parameters) {
    const ParameterSetting& before = known.config.parameters.at(name);
    if (!setting.free) {
      EXPECT_EQ(setting.value, before.value) << name;
    }
    EXPECT_EQ(setting.prior, before.prior) << name;
    EXPECT_TRUE(!setting.free || (setting.value >= setting.lower && setting.value <= setting.upper))
        << name;
  }
}

TEST(Comparison, TellsWhoWasSooner) {
  const std::string table = ComparisonAsMarkdown(MakeComparison());
  EXPECT_THAT(table,
              HasSubstr("| lm/joint | 100 | 100 | 2.1 | 61 | 71 | 0 | 1 of 1 | 10.0 | 5.0 |"));
  EXPECT_THAT(table,
              HasSubstr("| pattern/joint | 300 | 300 | - | 301 | 201 | 0 | 1 of 1 | 1.0 | 1.0 |"));
}

TEST(Comparison, SaysWhereTheOtherWasNeverReached) {
  Comparison comparison = MakeComparison();
  comparison.runs[0] = MakeRun("lm/joint", 0, {{1, 1, 900}});
  EXPECT_THAT(ComparisonAsMarkdown(comparison), HasSubstr("| 0 of 1 | - | - |"));
}

TEST(Comparison, ReadsBackWhatWasWritten) {
  const TestFolder folder;
  Comparison comparison = MakeComparison();
  comparison.runs[1].error = std::numeric_limits<double>::infinity();
  WriteComparison(folder.path() / "c.json", comparison);
  const Comparison read = ReadComparison(folder.path() / "c.json");
  EXPECT_EQ(ComparisonAsMarkdown(read), ComparisonAsMarkdown(comparison));
  EXPECT_EQ(ComparisonRunsAsCsv(read), ComparisonRunsAsCsv(comparison));
  EXPECT_EQ(ComparisonHistoryAsCsv(read), ComparisonHistoryAsCsv(comparison));
  folder.Write("bad.json", "{}");
  EXPECT_THROW(ReadComparison(folder.path() / "bad.json"), InputError);
}

TEST(Comparison, GoesOnFromWhatWasDone) {
  const SilhouetteScene known = MakeSilhouetteScene();
  ComparisonOptions options;
  options.contenders = {ParseContender("", "lm"), ParseContender("", "bobyqa")};
  options.num_starts = 1;
  options.budget.evaluations = 12.0;
  int done = 0;
  ComparisonCallbacks callbacks;
  callbacks.done = [&](const Comparison& so_far) {
    EXPECT_EQ(static_cast<int>(so_far.runs.size()), ++done);
  };
  const Comparison first = Compare(known.scene, known.config, options, nullptr, callbacks);
  EXPECT_EQ(done, 2);
  EXPECT_GT(first.derivative_cost, 1.0);
  options.num_starts = 2;
  const Comparison second = Compare(known.scene, known.config, options, &first, callbacks);
  EXPECT_EQ(done, 4);
  ASSERT_EQ(second.runs.size(), 4U);
  EXPECT_EQ(second.runs[0].seconds, first.runs[0].seconds);  // not run again
  EXPECT_EQ(second.runs[2].start, 1);
}

TEST(LineChart, TicksAreRound) {
  EXPECT_THAT(LinearTicks(0.0, 10.0, 5), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
  EXPECT_THAT(LogTicks(0.5, 2000.0), ElementsAre(1.0, 10.0, 100.0, 1000.0));
  EXPECT_EQ(LogTicks(30.0, 300.0).size(), 3U);  // 50, 100, 200
}

TEST(LineChart, LeavesOutWhatCannotBeDrawn) {
  Chart chart{"a < b", "x", "y", true, true, {{"one", {{0.0, 1.0}, {1.0, 10.0}, {10.0, 5.0}}}}};
  chart.lines[0].steps = true;
  const std::string svg = ChartsAsSvg({chart});
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(svg, testing::Not(HasSubstr("inf")));
  EXPECT_THAT(ChartsAsSvg({Chart()}), HasSubstr("</svg>"));
}

// The numbers after each ` key='` of the elements that begin with `element`.
std::vector<double> NumbersOf(const std::string& svg, const std::string& element,
                              const std::string& key) {
  std::vector<double> numbers;
  for (std::size_t at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1))
    numbers.push_back(std::stod(svg.substr(svg.find(" " + key + "='", at) + key.size() + 3)));
  return numbers;
}

TEST(LineChart, ZeroHasNoSign) {
  const std::vector<double> ticks = LinearTicks(-0.4, 0.4, 4);
  const auto zero = std::find(ticks.begin(), ticks.end(), 0.0);
  ASSERT_NE(zero, ticks.end());
  EXPECT_FALSE(std::signbit(*zero));
  const Chart chart{"", "x", "y", false, false, {{"one", {{0.0, 0.0}, {1.0, 1.0}}}}};
  EXPECT_THAT(ChartsAsSvg({chart}), testing::Not(HasSubstr(">-0<")));
}

// Wide names make fewer columns: no name reaches into the line of the next, and none is cut off.
TEST(LineChart, LegendHasRoomForItsNames) {
  constexpr double kWide = 7.0;  // px of a letter of 12 px
  for (const std::size_t length : {1U, 15U, 40U, 90U}) {
    Chart chart;
    for (int i = 0; i < 6; ++i) {
      chart.lines.push_back(
          {std::string(length, static_cast<char>('a' + i)), {{0.0, 0.0}, {1.0, 1.0}}});
    }
    const std::string svg = ChartsAsSvg({chart});
    const std::vector<double> x = NumbersOf(svg, "<text class='name'", "x");
    const std::vector<double> y = NumbersOf(svg, "<text class='name'", "y");
    ASSERT_EQ(x.size(), 6U);
    const double width = NumbersOf(svg, "<svg", "width").at(0);
    const double letters = kWide * static_cast<double>(length);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_LE(x[i] + letters, width) << length;
      if (i == 0) continue;
      const bool is_right_of = y[i] == y[i - 1] && x[i] - 30.0 > x[i - 1] + letters;
      EXPECT_TRUE(is_right_of || y[i] > y[i - 1] + 12.0) << length;
    }
    EXPECT_GT(NumbersOf(svg, "<svg", "height").at(0), y.back());
  }
}

}  // namespace
}  // namespace clothfit
