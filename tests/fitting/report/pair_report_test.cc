// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Two runs become one page: what differs, and by how much.
#include <cmath>

#include <fmt/format.h>

#include "fitting/files/npy_file.h"
#include "fitting/report/pair/run_pair.h"
#include "fitting/report/report.h"
#include "fitting/runs/fit_run.h"
#include "tests/fitting/report/test_assets.h"
#include "tests/support/report_blocks.h"
#include "tests/support/small_recording.h"
#include "tests/support/small_run.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A second fit of the small run's recording, on a finer mesh, with one more parameter held.
void MakeFinerRun(const fs::path& folder) {
  const Recording recording = ReadRecording(folder / "rec");
  FitConfig config = DefaultConfig(recording);
  config.recording = (folder / "rec").string();
  config.use_silhouettes = false;
  config.coarse_resolution = 0;
  config.max_iterations = 2;
  config.resolution = {7, 7};
  SetFree("--fix", "air_drag.saturation", false, &config);
  FitIntoRun(MakeScene(recording, config), config,
             RunFolder(folder / "finer", RunFolder::Existing::kReplace), {}, false);
}

// A fit of another recording, which is shorter.
void MakeOtherRun(const fs::path& folder) {
  SmallRecordingOptions options;
  options.particles = 5;
  options.frames = 8;
  WriteRecording(MakeSmallRecording(options), folder / "rec2");
  const Recording recording = ReadRecording(folder / "rec2");
  FitConfig config = DefaultConfig(recording);
  config.recording = (folder / "rec2").string();
  config.max_iterations = 1;
  FitIntoRun(MakeScene(recording, config), config,
             RunFolder(folder / "other", RunFolder::Existing::kReplace), {}, false);
}

class PairReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TestFolder;
    MakeSmallRun(made_->path());
    MakeFinerRun(made_->path());
    MakeOtherRun(made_->path());
    page_ =
        new ReportPage(MakePairReport(made_->path() / "run", made_->path() / "finer", kTestAssets));
  }
  static void TearDownTestSuite() {
    delete page_;
    delete made_;
  }
  static fs::path At(const char* name) { return made_->path() / name; }
  static json Section(const std::string& html, const std::string& id) {
    const json data = DataOfPage(html);
    for (const json& section : data.at("sections"))
      if (section.at("id") == id) return section;
    ADD_FAILURE() << "no section " << id;
    return {};
  }

  static TestFolder* made_;
  static ReportPage* page_;
};
TestFolder* PairReport::made_ = nullptr;
ReportPage* PairReport::page_ = nullptr;

TEST_F(PairReport, StandsAlone) {
  EXPECT_THAT(page_->html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page_->html, HasSubstr("<title>run beside finer"));
  EXPECT_THAT(page_->html, HasSubstr("Error in run → in finer"));
  EXPECT_THAT(page_->verdict.headline, HasSubstr("the held-out frames"));
  EXPECT_THAT(page_->notes, Contains(HasSubstr("run is drawn on that of finer")));
}

TEST_F(PairReport, HasItsSectionsInOrder) {
  std::vector<std::string> ids;
  const json data = DataOfPage(page_->html);
  for (const json& section : data.at("sections")) ids.push_back(section.at("id"));
  EXPECT_THAT(ids,
              ElementsAre("numbers", "parameters", "errors", "settings", "cloth-map", "cameras"));
}

TEST_F(PairReport, ShowsBothClothsOnTheFinerMesh) {
  const json data = DataOfPage(page_->html);
  EXPECT_EQ(data.at("shows_both"), true);
  ASSERT_EQ(data.at("motions").size(), 2u);
  EXPECT_EQ(data.at("motions")[0].at("title"), "run");
  EXPECT_EQ(data.at("motions")[1].at("title"), "finer");
  EXPECT_EQ(data.at("mesh").at("particles"), 49);
  for (const json& motion : data.at("motions"))
    EXPECT_EQ(motion.at("positions").at("shape"), (json{12, 49, 3}));
  // Corner (0, 0) is a particle of both meshes: the coarse one's must have come over unchanged.
  const std::vector<double> numbers =
      NumbersOfBlock(page_->html, data.at("motions")[0].at("positions"));
  const std::vector<Eigen::VectorXd> coarse = ReadPointsNpy(At("run") / "trajectory.npy");
  for (std::size_t f = 0; f < 12; ++f)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(numbers[f * 147 + c], coarse[f][static_cast<Eigen::Index>(c)], 1e-4);
  EXPECT_EQ(data.at("fields").back().at("name"), "apart");
}

// The table's numbers are those of the runs' own summaries.
TEST_F(PairReport, SetsErrorsSideBySide) {
  const json table = Section(page_->html, "numbers").at("blocks")[0];
  const json first = json::parse(ReadTextFile(At("run") / "summary.json"));
  const json second = json::parse(ReadTextFile(At("finer") / "summary.json"));
  int checked = 0;
  for (const json& row : table.at("rows")) {
    if (row[0] != "markers, rms, held out") continue;
    const double a = first.at("held_out").at("marker_rms_m"),
                 b = second.at("held_out").at("marker_rms_m");
    EXPECT_EQ(row[1], QuantityInWords(a, "m"));
    EXPECT_EQ(row[2], QuantityInWords(b, "m"));
    EXPECT_EQ(row[3], (b < a ? "-" : "+") + QuantityInWords(std::abs(b - a), "m"));
    EXPECT_EQ(row[4], fmt::format("{:+.0f} %", 100.0 * (b / a - 1.0)));
    ++checked;
  }
  EXPECT_EQ(checked, 1);
  EXPECT_THAT(table.at("rows").dump(), HasSubstr("chi-square of the residuals"));
}

TEST_F(PairReport, ListsWhatWasSetDifferently) {
  const json table = Section(page_->html, "settings").at("blocks")[0];
  std::vector<std::string> keys;
  for (const json& row : table.at("rows")) keys.push_back(row[0]);
  EXPECT_THAT(keys, ElementsAre("cloth.resolution", "strategy.max_iterations",
                                "parameters.air_drag.saturation.free"));
  EXPECT_EQ(table.at("rows")[1][1], "3");
  EXPECT_EQ(table.at("rows")[1][2], "2");
}

TEST_F(PairReport, DrawsBothErrorsInOneChart) {
  const json section = Section(page_->html, "errors");
  for (const json& chart : section.at("blocks")) EXPECT_EQ(chart.at("frames"), true);
  const json& markers = section.at("blocks")[0];
  ASSERT_EQ(markers.at("series").size(), 2u);
  EXPECT_EQ(markers.at("series")[0].at("name"), "run");
  EXPECT_EQ(markers.at("series")[1].at("role"), "after");
  EXPECT_EQ(markers.at("series")[1].at("values").size(), 12u);
  EXPECT_EQ(section.at("blocks").back().at("title"), "The two cloths from each other");
}

TEST_F(PairReport, MeasuresParametersInJointIntervals) {
  const RunPair pair = ReadRunPair(At("run"), At("finer"), {});
  int compared = 0, held = 0;
  for (const PairedParameter& parameter : PairParameters(pair.first.scene, pair.second.scene)) {
    held += parameter.first.is_free && !parameter.second.is_free ? 1 : 0;
    if (!parameter.in_joint_intervals) continue;
    const auto scale = [&](double value) { return parameter.is_log ? std::log(value) : value; };
    const auto half = [&](const PairedParameter::Side& side) {
      return 0.5 * (scale((*side.interval)[1]) - scale((*side.interval)[0]));
    };
    EXPECT_DOUBLE_EQ(*parameter.in_joint_intervals,
                     (scale(*parameter.second.value) - scale(*parameter.first.value)) /
                         std::hypot(half(parameter.first), half(parameter.second)));
    ++compared;
  }
  EXPECT_GT(compared, 0);
  EXPECT_EQ(held, 1);  // air_drag.saturation
  const json items = Section(page_->html, "parameters").at("blocks")[0].at("items");
  for (const json& item : items) {
    ASSERT_EQ(item.at("sides").size(), 2u);
    const bool is_held = item.at("name") == "air_drag.saturation";
    EXPECT_EQ(item.at("sides")[1].at("note") == "held", is_held) << item.at("name");
  }
}

TEST_F(PairReport, OfTwoRecordingsHasAllButTheCloths) {
  const ReportPage page = MakePairReport(At("run"), At("other"), kTestAssets);
  const json data = DataOfPage(page.html);
  EXPECT_FALSE(data.contains("motions"));
  EXPECT_THAT(page.verdict.headline, HasSubstr("are of two recordings"));
  EXPECT_THAT(page.notes, Contains(HasSubstr("cloths are not shown together")));
  const json chart = Section(page.html, "errors").at("blocks")[0];
  EXPECT_EQ(chart.at("x").at("values").size(), 12u);  // the shorter one's times are among them
  EXPECT_EQ(chart.at("series")[1].at("values")[11], nullptr);
  EXPECT_EQ(Section(page.html, "settings").at("blocks")[0].at("title"), "Recordings");
}

TEST_F(PairReport, NoNameBecomesMarkup) {
  const std::string name = "<b onclick=x>";
  fs::copy(At("run"), At(name.c_str()), fs::copy_options::recursive);
  const ReportPage page = MakePairReport(At("finer"), At(name.c_str()), kTestAssets);
  EXPECT_THAT(page.html, Not(HasSubstr("<b onclick")));
  EXPECT_THAT(page.html, HasSubstr("&lt;b onclick=x&gt;"));
  fs::remove_all(At(name.c_str()));
}

TEST_F(PairReport, RefusesWhatIsNoPair) {
  const auto error = [](const fs::path& a, const fs::path& b, const ReportOptions& options = {}) {
    return InputErrorOf([&] { MakePairReport(a, b, kTestAssets, options); });
  };
  EXPECT_THAT(error(At("run"), At("run") / "."), HasSubstr("is the same run as"));
  EXPECT_THAT(error(At("run"), At("rec")), HasSubstr("is a recording;"));
  EXPECT_THAT(error(At("none"), At("run")), HasSubstr("no such folder"));
  ReportOptions options;
  options.pictures = At("rec");
  EXPECT_THAT(error(At("run"), At("other"), options), HasSubstr("--pictures: cannot be those of"));
}

TEST(NamesApart, AreAsShortAsTheyTellApart) {
  EXPECT_THAT(NamesApart("runs/a", "runs/b/"), ElementsAre("a", "b"));
  EXPECT_THAT(NamesApart("/x/a/fit", "/x/b/fit"), ElementsAre("a/fit", "b/fit"));
  EXPECT_THAT(NamesApart("/a/r", "/b/c/r"), ElementsAre("a/r", "c/r"));
}

}  // namespace
}  // namespace clothfit
