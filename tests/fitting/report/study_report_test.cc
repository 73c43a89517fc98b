// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Comparisons and studies become pages, and what is neither is told so.
#include "fitting/report/kinds.h"
#include "fitting/report/page/markdown_blocks.h"
#include "fitting/studies/comparison.h"
#include "tests/fitting/report/test_assets.h"
#include "tests/support/report_blocks.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

ComparedRun MakeRun(const std::string& contender, double simulations, double error) {
  ComparedRun run;
  run.contender = contender;
  run.error = run.open_loop_error = error;
  run.simulations = simulations;
  run.seconds = 0.1 * simulations;
  run.history = {{1.0, 0.1, 100.0}, {simulations, 0.1 * simulations, error}};
  return run;
}

class FolderReport : public testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories(folder());
    WriteWholeFile(folder() / name, text);
  }
  // The slow one ends higher, after 20 times as many simulations.
  void WriteSmallComparison() const {
    Comparison comparison;
    comparison.recording = "lift";
    comparison.contenders = {"fast/joint", "slow/joint"};
    comparison.runs = {MakeRun("fast/joint", 10.0, 20.0), MakeRun("slow/joint", 200.0, 30.0)};
    Write("config.yaml", "format: clothfit-config/1\n");
    Write("conditions.yaml", "spread: 0.5\nseed: 1\nmax_simulations: inf\n");
    WriteComparison(folder() / "comparison.json", comparison);
  }
  std::string Html() const { return MakeReport(folder(), kTestAssets).html; }
  std::string ErrorOf() const {
    return InputErrorOf([this] { MakeReport(folder(), kTestAssets); });
  }
  fs::path folder() const { return test_.path() / "results"; }

  TestFolder test_;
};

TEST_F(FolderReport, OfAComparisonSaysWhoCameLowerAndByHowMuch) {
  WriteSmallComparison();
  const std::string html = Html();
  EXPECT_THAT(html, HasSubstr("<h1>fast/joint ends lower than slow/joint.</h1>"));
  EXPECT_THAT(html, HasSubstr("with 20 times fewer simulations and 20 times sooner"));
  const json data = DataOfPage(html);
  const json chart = data.at("sections")[0].at("blocks")[0];
  EXPECT_EQ(chart.at("x").at("values"), (json{1.0, 10.0, 200.0}));
  EXPECT_EQ(chart.at("series")[0].at("values"), (json{100.0, 20.0, nullptr}));
  EXPECT_EQ(data.at("sections")[1].at("blocks")[1].at("rows").size(), 2u);
}

TEST_F(FolderReport, OfAComparisonNamesTheFileThatIsMissing) {
  WriteSmallComparison();
  fs::remove(folder() / "comparison.json");
  EXPECT_THAT(ErrorOf(), HasSubstr("comparison.json: is missing"));
  Write("comparison.json", "{\"format\": \"clothfit-comparison/0\"}");
  EXPECT_THAT(ErrorOf(), HasSubstr("expected clothfit-comparison/1"));
  WriteComparison(folder() / "comparison.json", Comparison{});
  EXPECT_THAT(ErrorOf(), HasSubstr("holds no run that ended"));
  WriteSmallComparison();
  fs::remove(folder() / "config.yaml");
  EXPECT_THAT(ErrorOf(), HasSubstr("config.yaml: is missing"));
}

TEST_F(FolderReport, OfAStudyTakesItsTextsPicturesAndTables) {
  Write("thing.md", "Ten runs.\n\n| a | b |\n|---|---:|\n| x | 2 |\n\nAll of them work. Really.\n");
  Write("thing.csv", "name,value\n\"one, two\",3\n<b>,\n");
  Write("thing.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  Write("conditions.yaml", "plan: quick\n");
  Write("commitments.csv", "trial,sha256\n");
  const std::string html = Html();
  EXPECT_THAT(html, HasSubstr("<h1>All of them work.</h1>"));
  EXPECT_THAT(html, HasSubstr("<li>Ten runs.</li>"));
  EXPECT_THAT(html, Not(HasSubstr("<b>")));  // no text of a table becomes markup
  const json sections = DataOfPage(html).at("sections");
  ASSERT_EQ(sections.size(), 4u);
  EXPECT_EQ(sections[0].at("blocks")[1].at("rows"), (json::array({json::array({"x", 2.0})})));
  EXPECT_EQ(sections[1].at("blocks")[0].at("type"), "image/svg+xml");
  EXPECT_EQ(sections[2].at("blocks")[1].at("rows")[0], (json::array({"one, two", 3.0})));
  EXPECT_EQ(sections[2].at("blocks")[1].at("rows")[1], (json::array({"<b>", nullptr})));
}

TEST_F(FolderReport, OfAnUnfinishedStudySaysSo) {
  Write("thing.csv", "");
  EXPECT_THAT(ErrorOf(), HasSubstr("no .md file; expected a study that has ended"));
  Write("thing.md", "Done.\n");
  EXPECT_THAT(ErrorOf(), HasSubstr("thing.csv: is empty; expected a study that has ended"));
}

TEST_F(FolderReport, OfAnythingElseSaysWhatItIs) {
  EXPECT_THAT(ErrorOf(), HasSubstr("does not exist"));
  Write("recording.yaml", "name: x\n");
  EXPECT_THAT(ErrorOf(), HasSubstr("recording.yaml"));
  fs::rename(folder() / "recording.yaml", folder() / "notes.pdf");
  EXPECT_THAT(ErrorOf(), HasSubstr("is not the folder of a recording, a run or a study"));
  EXPECT_THAT(InputErrorOf([this] { MakeReport(folder() / "notes.pdf", kTestAssets); }),
              HasSubstr("is no folder"));
}

TEST(ParseMarkdown, KeepsWhatItDoesNotKnow) {
  const MarkdownPage page = ParseMarkdown(
      "# Title\n\n- one `code`\n- **two** [three](x.md)\n\n## More\n\n```\nrun\n```\n| no table\n");
  EXPECT_EQ(page.title, "Title");
  EXPECT_THAT(page.paragraphs, testing::ElementsAre("one code", "two three", "| no table"));
  EXPECT_EQ(page.blocks[2].at("kind"), "heading");
  EXPECT_EQ(page.blocks[3].at("text"), "run\n");
}

}  // namespace
}  // namespace clothfit
