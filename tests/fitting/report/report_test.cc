// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A run becomes a page that holds all of it.
#include "fitting/report/report.h"

#include <cmath>

#include "fitting/files/npy_file.h"
#include "fitting/report/page/html.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/facts.h"
#include "tests/fitting/report/test_assets.h"
#include "tests/support/report_blocks.h"
#include "tests/support/small_run.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TestFolder;
    MakeSmallRun(made_->path());
    page_ = new ReportPage(MakeReport(RunFolder::Open(made_->path() / "run"), kTestAssets));
  }
  static void TearDownTestSuite() {
    delete page_;
    delete made_;
  }
  // A copy of the run that may be spoilt; its recording stays where it is.
  Report() { fs::copy(made_->path() / "run", run_, fs::copy_options::recursive); }
  std::string ErrorOf() const {
    return InputErrorOf([this] { MakeReport(RunFolder::Open(run_), kTestAssets); });
  }

  static TestFolder* made_;
  static ReportPage* page_;
  TestFolder folder_;
  fs::path run_ = folder_.path() / "run";
};
TestFolder* Report::made_ = nullptr;
ReportPage* Report::page_ = nullptr;

// What a fit measured comes back from summary.json.
TEST_F(Report, KnowsHowTheFitMeetsItsNoise) {
  const VerdictFacts facts = FactsOf(ReadRunRecord(RunFolder::Open(run_)));
  ASSERT_TRUE(facts.misfit);
  EXPECT_GT(facts.misfit->observed, 0);
  EXPECT_GT(facts.misfit->chi_square, 0.0);
  EXPECT_GT(facts.misfit->limit, 1.0);
  EXPECT_GE(facts.misfit->correlation, 1.0);
  EXPECT_TRUE(facts.misfit->discretisation && facts.misfit->amplitude &&
              facts.misfit->without_discretisation);
  EXPECT_EQ(facts.left_out, "");
  EXPECT_FALSE(facts.recording.empty());
  EXPECT_THAT(page_->html, HasSubstr("chi-square"));
}

TEST_F(Report, TellsHowFarMarkersSitFromTheirPlaces) {
  EXPECT_EQ(FactsOf(ReadRunRecord(RunFolder::Open(run_))).marker_places, "");
  json summary = json::parse(ReadTextFile(run_ / "summary.json"));
  ASSERT_TRUE(summary.at("marker_places").is_null());
  summary["marker_places"] = {{"in_words", "3.0 mm, at most 7.0 mm (marker 8)"}};
  WriteWholeFile(run_ / "summary.json", summary.dump());
  EXPECT_THAT(MakeReport(RunFolder::Open(run_), kTestAssets).html,
              HasSubstr("as noise.layout lets them: by 3.0 mm, at most 7.0 mm (marker 8)."));
}

TEST_F(Report, StandsAlone) {
  EXPECT_THAT(page_->html, HasSubstr("<!doctype html>"));
  EXPECT_THAT(page_->html, HasSubstr(EscapeHtml(page_->verdict.headline)));
  EXPECT_THAT(page_->html, HasSubstr("<script>/* script */</script>"));
  EXPECT_THAT(page_->html, HasSubstr("<style>/* style */</style>"));
  EXPECT_THAT(page_->html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page_->html, Not(HasSubstr("http://")));
  EXPECT_THAT(page_->html, Not(HasSubstr("https://")));
}

TEST_F(Report, HoldsTheTrajectoryToHalfAStep) {
  const json data = DataOfPage(page_->html);
  ASSERT_EQ(data.at("motions").size(), 2u);
  const json& block = data.at("motions")[1].at("positions");
  const std::vector<double> numbers = NumbersOfBlock(page_->html, block);
  const std::vector<Eigen::VectorXd> frames = ReadPointsNpy(run_ / "trajectory.npy");
  ASSERT_EQ(numbers.size(), frames.size() * static_cast<std::size_t>(frames[0].size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(frames[0].size());
    const double range =
        block.at("upper")[i % 3].get<double>() - block.at("lower")[i % 3].get<double>();
    EXPECT_NEAR(numbers[i], frames[i / row][static_cast<Eigen::Index>(i % row)],
                range / 131068.0 + 1e-12);
  }
}

TEST_F(Report, HasFieldsForEveryParticleAndFrame) {
  const json data = DataOfPage(page_->html);
  std::vector<std::string> names;
  for (const json& field : data.at("fields")) {
    names.push_back(field.at("name"));
    for (const char* motion : {"before", "after"}) {
      EXPECT_EQ(field.at("values").at(motion).at("shape"), (json{12, 25, 1})) << names.back();
    }
  }
  EXPECT_THAT(names, testing::ElementsAre("residual", "outline", "strain", "speed"));
  // The residual of the fit is small where it is known at all, and markers are everywhere.
  for (const double value :
       NumbersOfBlock(page_->html, data.at("fields")[0].at("values").at("after"))) {
    EXPECT_LT(value, 0.1);  // m, a quarter of the cloth
  }
}

// The masks of the small recording are a square that has nothing to do with the cloth, 1.5 m away.
TEST_F(Report, ColoursByTheDistanceOfTheOutlines) {
  const json data = DataOfPage(page_->html);
  int known = 0;
  for (const double value :
       NumbersOfBlock(page_->html, data.at("fields")[1].at("values").at("after"))) {
    if (std::isnan(value)) continue;
    EXPECT_GE(value, 0.0);
    EXPECT_LT(value, 1.5);  // m; the picture is 1.6 m wide there
    ++known;
  }
  EXPECT_GT(known, 100);  // of 300
}

TEST_F(Report, HasEveryCameraWithPicturesAndOutlines) {
  const json data = DataOfPage(page_->html);
  ASSERT_EQ(data.at("cameras").size(), 2u);
  for (const json& camera : data.at("cameras")) {
    EXPECT_EQ(camera.at("pictures").at("frames").size(), 12u);
    EXPECT_EQ(camera.at("outlines").at("polygons").at("shape")[0], 12);
    const std::string id = "blob-" + camera.at("pictures").at("blob").dump();
    const std::string jpegs = FromBase64(ScriptOfPage(page_->html, id));
    EXPECT_EQ(jpegs.size(), camera.at("pictures").at("ends").back());
    EXPECT_EQ(jpegs.substr(0, 2), "\xff\xd8");  // JPEG's start of image
  }
}

TEST_F(Report, HasTheSectionsInOrder) {
  std::vector<std::string> ids;
  const json data = DataOfPage(page_->html);
  for (const json& section : data.at("sections")) ids.push_back(section.at("id"));
  EXPECT_THAT(ids, testing::ElementsAre("cameras", "errors", "cloth-map", "parameters",
                                        "convergence", "time", "configuration"));
}

TEST_F(Report, LeavesPicturesOutUntilItIsSmallEnough) {
  ReportOptions options;
  options.max_megabytes = 0.045;
  const ReportPage page = MakeReport(RunFolder::Open(run_), kTestAssets, options);
  EXPECT_LT(page.html.size(), page_->html.size());
  EXPECT_THAT(page.notes, testing::Contains(HasSubstr("To keep this page small")));
  EXPECT_LT(DataOfPage(page.html)["cameras"][0]["pictures"]["frames"].size(), 12u);
}

// An .npy file of frames x particles, all ones. `as`: the shape that its header claims.
void WriteScalars(const fs::path& file, int frames, const std::string& as) {
  std::string npy = PointsAsNpy(
      std::vector<Eigen::VectorXd>(static_cast<std::size_t>(frames), Eigen::VectorXd::Ones(75)));
  const std::string shape = "(" + std::to_string(frames) + ", 25, 3)";
  std::string padded = as;
  padded.resize(shape.size(), ' ');
  WriteWholeFile(file, npy.replace(npy.find(shape), shape.size(), padded));
}

TEST_F(Report, TakesSectionsAndFieldsFromTheRun) {
  fs::create_directories(run_ / "report");
  WriteWholeFile(run_ / "report" / "extra.json", R"({
    "fields": [{"name": "force", "title": "Missing force", "unit": "N/m^2",
                "values": {"after": "force.npy"}}],
    "sections": [{"id": "ranking", "title": "What is missing",
                  "blocks": [{"kind": "text", "paragraphs": ["<b>wind</b>"]}]}],
    "obstacles": [{"name": "table", "positions": "table.npy", "triangles": [[0, 1, 2]]}]})");
  WriteWholeFile(run_ / "report" / "table.npy", PointsAsNpy({Eigen::VectorXd::Zero(6)}));
  WriteScalars(run_ / "report" / "force.npy", 12, "(12, 75)");
  EXPECT_THAT(ErrorOf(), HasSubstr("has 12 frames of 75 numbers; expected 12 of 25"));
  WriteScalars(run_ / "report" / "force.npy", 4, "(12, 25)");
  EXPECT_THAT(ErrorOf(), HasSubstr("has 2 vertices; a triangle names vertex 2"));
  WriteWholeFile(run_ / "report" / "table.npy", PointsAsNpy({Eigen::VectorXd::Zero(9)}));
  const std::string html = MakeReport(RunFolder::Open(run_), kTestAssets).html;
  const json data = DataOfPage(html);
  EXPECT_EQ(data.at("fields").back().at("name"), "force");
  EXPECT_EQ(data.at("obstacles")[0].at("positions").at("shape"), (json{1, 3, 3}));
  EXPECT_EQ(data.at("sections")[4].at("id"), "ranking");
  EXPECT_THAT(html, Not(HasSubstr("<b>wind")));  // no text of a run becomes markup
  WriteWholeFile(run_ / "report" / "extra.json", "{\"sections\": [{}]}");
  EXPECT_THAT(ErrorOf(), HasSubstr("is no addition to a report"));
  std::string deep(1'000'000, '[');
  deep += std::string(deep.size(), ']');
  WriteWholeFile(run_ / "report" / "extra.json",
                 R"({"sections": [{"id": "a", "title": "b", "blocks": )" + deep + "}]}");
  EXPECT_THAT(ErrorOf(), HasSubstr("extra.json: is nested too deep"));
}

// By what the fit found, not by what its config began with.
TEST_F(Report, ShowsUnseenObstaclesWhereTheFitHasThem) {
  json summary = json::parse(ReadTextFile(run_ / "summary.json"));
  summary["parameters"]["obstacle_sphere.stiffness"] = summary["parameters"].front();
  summary["parameters"]["obstacle_sphere.stiffness"]["value"] = 1e4;
  WriteWholeFile(run_ / "summary.json", summary.dump());
  const json obstacles =
      DataOfPage(MakeReport(RunFolder::Open(run_), kTestAssets).html)["obstacles"];
  ASSERT_EQ(obstacles.size(), 1u);
  EXPECT_EQ(obstacles[0].at("name"), "unseen ball");
  EXPECT_TRUE(DataOfPage(page_->html).at("obstacles").empty());
}

TEST_F(Report, NamesTheFileThatIsMissing) {
  int checked = 0;
  for (const char* name : {"summary.json", "config.yaml", "parameters.yaml", "trajectory.npy"}) {
    fs::rename(run_ / name, run_ / "away");
    EXPECT_THAT(ErrorOf(), HasSubstr(std::string(name))) << name;
    EXPECT_THAT(ErrorOf(), Not(HasSubstr("\n")));
    fs::rename(run_ / "away", run_ / name);
    ++checked;
  }
  EXPECT_EQ(checked, 4);
}

TEST_F(Report, RefusesWhatIsDamagedOrOfAnotherVersion) {
  std::string summary = ReadTextFile(run_ / "summary.json");
  const std::string version = "\"clothfit\": \"" CLOTHFIT_VERSION "\"";
  WriteWholeFile(run_ / "summary.json",
                 std::string(summary).replace(summary.find(version), version.size(),
                                              "\"clothfit\": \"0.0.1\""));
  EXPECT_THAT(ErrorOf(), HasSubstr("was written by clothfit 0.0.1; expected " CLOTHFIT_VERSION));
  WriteWholeFile(run_ / "summary.json", "{");
  EXPECT_THAT(ErrorOf(), HasSubstr("summary.json: is damaged"));
  WriteWholeFile(run_ / "summary.json", "{" + version + "}");
  EXPECT_THAT(ErrorOf(), HasSubstr("status is missing"));
  WriteWholeFile(run_ / "summary.json", summary);
  WriteWholeFile(run_ / "trajectory.npy", "no numbers");
  EXPECT_THAT(ErrorOf(), HasSubstr("trajectory.npy: is damaged; expected an .npy file"));
  WriteWholeFile(run_ / "trajectory.npy", PointsAsNpy({Eigen::VectorXd::Zero(30)}));
  EXPECT_THAT(ErrorOf(), HasSubstr("has 1 frames of 10 particles; expected at most 12 of 25"));
}

TEST(EscapeHtml, LeavesNoMarkup) {
  EXPECT_EQ(EscapeHtml("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
}

}  // namespace
}  // namespace clothfit
