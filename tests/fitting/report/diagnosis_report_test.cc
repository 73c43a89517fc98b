// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis becomes a page: the baseline beside the model, and every step of the answer.
#include <algorithm>
#include <cmath>

#include "fitting/report/report.h"
#include "tests/fitting/report/test_assets.h"
#include "tests/support/report_blocks.h"
#include "tests/support/small_diagnosis.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class DiagnosisReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TestFolder;
    MakeSmallDiagnosis(made_->path());
    html_ = new std::string(MakeReport(made_->path() / "diagnosis", kTestAssets).html);
  }
  static void TearDownTestSuite() {
    delete html_;
    delete made_;
  }
  // A copy that may be spoilt; its recording stays where it is.
  DiagnosisReport() { fs::copy(made_->path() / "diagnosis", folder_, fs::copy_options::recursive); }
  std::string ErrorOf() const {
    return InputErrorOf([this] { MakeReport(folder_, kTestAssets); });
  }
  static json SectionNamed(const std::string& id) {
    const json data = DataOfPage(*html_);
    for (const json& section : data.at("sections")) {
      if (section.at("id") == id) return section;
    }
    ADD_FAILURE() << "no section " << id;
    return {};
  }

  static TestFolder* made_;
  static std::string* html_;
  TestFolder spoilt_;
  fs::path folder_ = spoilt_.path() / "diagnosis";
};
TestFolder* DiagnosisReport::made_ = nullptr;
std::string* DiagnosisReport::html_ = nullptr;

TEST_F(DiagnosisReport, SaysTheAnswerFirst) {
  const std::string headline =
      "Wind of 1 m/s (0.5 to 1.5) along +x, or gust of 1 m/s (0.5 to 1.5) along +x: this "
      "recording cannot tell.";
  EXPECT_THAT(*html_, HasSubstr("<h1>" + headline + "</h1>"));
  EXPECT_THAT(*html_, Not(HasSubstr("<li>Wind of 1 m/s")));  // the headline says it
  EXPECT_THAT(*html_, HasSubstr("<li>The same motion twice as fast would: they would be 12 mm "
                                "apart, here it is 3.0.</li>"));
  EXPECT_THAT(*html_, HasSubstr("Error of the baseline"));
  const json record = json::parse(ReadTextFile(folder_ / "diagnosis.json"));
  EXPECT_EQ(record.at("headline"), headline);
  EXPECT_THAT(ReadTextFile(folder_ / "diagnosis.md"), testing::StartsWith("# " + headline + "\n"));
}

// A gust is tied to the clock and wind to the world; friction of bending and of shear are alike.
TEST_F(DiagnosisReport, IsAsGoodAsWhatItCannotTellApartIsAlike) {
  const fs::path file = folder_ / "diagnosis.json";
  const auto grade_of = [&](const std::vector<std::string>& set,
                            const std::vector<std::vector<std::string>>& beside = {}) {
    json record = json::parse(ReadTextFile(file));
    record["ambiguity"] = set;
    record["ambiguity_beside"] = beside;
    WriteWholeFile(file, record.dump());
    const std::string html = MakeReport(folder_, kTestAssets).html;
    const std::string mark = "data-grade=\"";
    const std::size_t begin = html.find(mark) + mark.size();
    return html.substr(begin, html.find('"', begin) - begin);
  };
  EXPECT_EQ(grade_of({"wind"}), "good");
  EXPECT_EQ(grade_of({"wind", "gust"}), "partial");
  EXPECT_EQ(grade_of({"bending_friction", "shear_friction"}), "good");
  EXPECT_EQ(grade_of({"wind", "camera cam0: pose"}), "partial");
  EXPECT_EQ(grade_of({"wind"}, {{"bending_friction", "shear_friction"}}), "good");
  EXPECT_EQ(grade_of({"wind"}, {{"hem", "gust"}}), "partial");
}

TEST_F(DiagnosisReport, ShowsTheBaselineAndTheModel) {
  const json data = DataOfPage(*html_);
  ASSERT_EQ(data.at("motions").size(), 2u);
  EXPECT_EQ(data.at("motions")[0].at("title"), "Baseline");
  EXPECT_EQ(data.at("motions")[1].at("title"), "With wind");
  EXPECT_EQ(data.at("clock").at("held_out"), (json::array({json::array({8, 11})})));
  int checked = 0;
  for (const json& error : data.at("errors")) {
    if (error.at("kind") != "markers") continue;
    EXPECT_GT(error.at("before"), error.at("after"));  // the baseline is 17 mm beside
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

TEST_F(DiagnosisReport, ColoursByTheMissingForceWhereItIsKnown) {
  const json fields = DataOfPage(*html_).at("fields");
  ASSERT_GE(fields.size(), 3u);
  EXPECT_EQ(fields[0].at("name"), "residual");
  EXPECT_EQ(fields[1].at("name"), "missing_force");
  const std::vector<double> values = NumbersOfBlock(*html_, fields[1].at("values").at("before"));
  ASSERT_EQ(values.size(), 12u * 25u);
  EXPECT_NEAR(values[0], std::sqrt(3.0) * 0.1, 1e-4);  // three components of 0.1; 16 bits
  EXPECT_TRUE(std::isfinite(values[9 * 25 - 1]));
  EXPECT_TRUE(std::isnan(values[9 * 25]));  // beyond the frames that it was looked for in
}

TEST_F(DiagnosisReport, HasEveryStepOfTheAnswer) {
  std::vector<std::string> ids;
  const json data = DataOfPage(*html_);
  for (const json& section : data.at("sections")) ids.push_back(section.at("id"));
  EXPECT_THAT(ids,
              testing::ElementsAre("cameras", "ranking", "location", "class", "proof", "parameters",
                                   "nulls", "errors", "cloth-map", "time", "configuration"));
}

TEST_F(DiagnosisReport, MarksWhatCannotBeToldApart) {
  const json bars = SectionNamed("ranking").at("blocks")[1].at("items");
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_EQ(bars[0].at("marked"), true);
  EXPECT_EQ(bars[1].at("marked"), true);  // gust
  EXPECT_EQ(bars[2].at("marked"), false);
  EXPECT_EQ(bars[2].at("muted"), true);
}

// Every draw of the null stands in one bin, and the recording where it belongs.
TEST_F(DiagnosisReport, ShowsTheRecordingBesideTheDrawsOfTheNull) {
  const json block = SectionNamed("nulls").at("blocks")[1];
  ASSERT_EQ(block.at("kind"), "lines");
  const json places = block.at("x").at("values");
  const json of_null = block.at("series")[0].at("values"), own = block.at("series")[1].at("values");
  ASSERT_EQ(of_null.size(), places.size());
  ASSERT_EQ(own.size(), places.size());
  double draws = 0.0, recordings = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_GE(places[i], places[i == 0 ? 0 : i - 1]);
    if (of_null[i].is_number() && of_null[i] != 0.0) {
      draws += of_null[i].get<double>();
      EXPECT_NEAR(places[i].get<double>(), 1.0, 0.041);
    }
    if (own[i].is_number()) {
      recordings += own[i].get<double>();
      EXPECT_EQ(places[i], 1.35);
    }
  }
  EXPECT_EQ(draws, 400.0);
  EXPECT_EQ(recordings, 1.0);
}

TEST_F(DiagnosisReport, ShowsObstaclesThatMove) {
  const fs::path other = spoilt_.path() / "rec";
  fs::copy(made_->path() / "rec", other, fs::copy_options::recursive);
  Recording recording = ReadRecording(other);
  ObstacleDescription ball;
  ball.name = "ball";
  ball.shape = BallShape{0.1};
  ball.path.assign(static_cast<std::size_t>(recording.frame_count), {});
  for (std::size_t f = 0; f < ball.path.size(); ++f)
    ball.path[f].position = Eigen::Vector3d(0.0, 0.0, -3.0 + 0.01 * static_cast<double>(f));
  recording.obstacles = {ball};
  WriteRecording(recording, other, Overwrite::kAllow);
  FitConfig config = DefaultConfig(ReadRecording(other));
  ReadConfig(folder_ / "config.yaml", &config);
  config.recording = other.string();
  WriteWholeFile(folder_ / "config.yaml", ConfigToYaml(config));
  const std::string html = MakeReport(folder_, kTestAssets).html;
  const json data = DataOfPage(html);
  ASSERT_EQ(data.at("obstacles").size(), 1u);
  const json& positions = data.at("obstacles")[0].at("positions");
  const std::vector<double> numbers = NumbersOfBlock(html, positions);
  const auto frames = static_cast<std::size_t>(recording.frame_count);
  ASSERT_EQ(positions.at("shape")[0], frames);
  const std::size_t last = numbers.size() / frames * (frames - 1);
  EXPECT_NEAR(numbers[last + 2] - numbers[2], 0.01 * static_cast<double>(frames - 1), 1e-4);
}

// That the recording does not know of: it is what was found.
TEST_F(DiagnosisReport, ShowsTheObstacleOfItsAnswer) {
  EXPECT_TRUE(DataOfPage(*html_).at("obstacles").empty());
  const fs::path file = folder_ / "config.yaml";
  FitConfig config = DefaultConfig(ReadRecording(made_->path() / "rec"));
  ReadConfig(file, &config);
  config.recording = (made_->path() / "rec").string();
  config.parameters.at("obstacle_table.stiffness").value = 1e4;
  config.parameters.at("obstacle_table.x2").value = 1.0;
  WriteWholeFile(file, ConfigToYaml(config));
  const json data = DataOfPage(MakeReport(folder_, kTestAssets).html);
  ASSERT_EQ(data.at("obstacles").size(), 1u);
  EXPECT_EQ(data.at("obstacles")[0].at("name"), "unseen table");
}

// The errors on the page are of what the diagnosis went by, as those of its sentences are.
TEST_F(DiagnosisReport, LeavesOutWhatTheDiagnosisLeftOut) {
  const auto error_of = [](const std::string& html) {
    const json data = DataOfPage(html);
    for (const json& error : data.at("errors")) {
      if (error.at("kind") == "markers" && error.at("held_out") == true)
        return error.at("after").get<double>();
    }
    return -1.0;
  };
  const fs::path other = spoilt_.path() / "rec";
  fs::copy(made_->path() / "rec", other, fs::copy_options::recursive);
  Recording recording = ReadRecording(other);
  const auto wild =
      std::find_if(recording.markers.begin(), recording.markers.end(),
                   [](const Marker& marker) { return marker.frame == 9 && marker.id == 5; });
  ASSERT_NE(wild, recording.markers.end());
  wild->position.z() += 0.5;
  WriteRecording(recording, other, Overwrite::kAllow);
  FitConfig config = DefaultConfig(ReadRecording(other));
  ReadConfig(folder_ / "config.yaml", &config);
  config.recording = other.string();
  WriteWholeFile(folder_ / "config.yaml", ConfigToYaml(config));
  const double clean = error_of(*html_);
  ASSERT_GT(clean, 0.0);
  EXPECT_NEAR(error_of(MakeReport(folder_, kTestAssets).html), clean, 0.2 * clean);
  config.leave_out_outliers = false;
  WriteWholeFile(folder_ / "config.yaml", ConfigToYaml(config));
  EXPECT_GT(error_of(MakeReport(folder_, kTestAssets).html), 2.0 * clean);
}

TEST_F(DiagnosisReport, OfChiSquaredTablesHasNoDraws) {
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  record.at("gate")["null_left_rms_sigmas"] = json::array();
  WriteWholeFile(file, record.dump());
  const json data = DataOfPage(MakeReport(folder_, kTestAssets).html);
  for (const json& section : data.at("sections")) {
    if (section.at("id") != "nulls") continue;
    for (const json& block : section.at("blocks")) EXPECT_NE(block.at("kind"), "lines");
  }
}

TEST_F(DiagnosisReport, SaysWhichFramesAValidationIsOn) {
  EXPECT_THAT(*html_, HasSubstr("Error on held-out frames"));
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  for (json* model : {&record.at("answer"), &record.at("models").at(0)})
    model->at("held_out")["earlier_frames"] = {13, 26};
  WriteWholeFile(file, record.dump());
  const std::string page = MakeReport(folder_, kTestAssets).html;
  EXPECT_THAT(page, Not(HasSubstr("Error on held-out frames")));
  EXPECT_THAT(page, HasSubstr("Error on frames 13 to 26, after fits to those before them alone"));
  EXPECT_THAT(page, HasSubstr("validated on frames 13 to 26"));
}

TEST_F(DiagnosisReport, NamesWhatIsMissing) {
  int checked = 0;
  for (const char* name :
       {"diagnosis.json", "config.yaml", "log.txt", "baseline.npy", "model.npy"}) {
    fs::rename(folder_ / name, spoilt_.path() / "away");
    EXPECT_THAT(ErrorOf(), HasSubstr(std::string(name) + ": is missing; expected a diagnosis"));
    fs::rename(spoilt_.path() / "away", folder_ / name);
    ++checked;
  }
  EXPECT_EQ(checked, 5);
}

TEST_F(DiagnosisReport, RefusesAnotherVersion) {
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  record["clothfit"] = "0.0.1";
  WriteWholeFile(file, record.dump());
  EXPECT_THAT(ErrorOf(), HasSubstr("was written by clothfit 0.0.1"));
  record["clothfit"] = CLOTHFIT_VERSION;
  record.erase("resolution");
  WriteWholeFile(file, record.dump());
  EXPECT_THAT(ErrorOf(), HasSubstr("is no diagnosis that can be shown"));
  WriteWholeFile(file, "[]");
  EXPECT_THAT(ErrorOf(), HasSubstr("is damaged; expected a JSON object"));
}

TEST_F(DiagnosisReport, OfOneThatFoundNothingShowsTheBaselineAlone) {
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  record["verdict"] = "nothing is missing";
  record["headline"] = record["words"] = "Nothing is missing that this recording could show.";
  record["effects"] = record["ambiguity"] = record["models"] = json::array();
  for (const char* key : {"answer", "mismatch", "class"}) record[key] = nullptr;
  WriteWholeFile(file, record.dump());
  for (const char* name : {"model.npy", "missing-force.npy"}) fs::remove(folder_ / name);
  const std::string html = MakeReport(folder_, kTestAssets).html;
  const json data = DataOfPage(html);
  EXPECT_THAT(html, HasSubstr("<h1>Nothing is missing that this recording could show.</h1>"));
  EXPECT_EQ(data.at("motions").size(), 1u);
  EXPECT_TRUE(data.at("errors")[0].at("after").is_null());
  record["gate"] = nullptr;
  WriteWholeFile(file, record.dump());
  EXPECT_THAT(ErrorOf(), HasSubstr("is damaged, or of another version of clothfit"));
}

// Of 0.1.0, which had no headline; and errors of a fault are against the recording that has it.
TEST_F(DiagnosisReport, OfAnEarlierVersionBeginsWithItsFirstSentence) {
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  record.erase("headline");
  record["words"] = "What was left out: a camera. It is turned by 0.5 degrees. That is a fault.";
  record["verdict"] = "observation fault";
  WriteWholeFile(file, record.dump());
  const std::string html = MakeReport(folder_, kTestAssets).html;
  EXPECT_THAT(html, HasSubstr("<h1>What was left out: a camera.</h1>"));
  EXPECT_THAT(html, HasSubstr("against the recording with its fault"));
}

TEST_F(DiagnosisReport, OfOneThatWasInterruptedShowsNoIntervals) {
  const json finished = SectionNamed("parameters").at("blocks")[0].at("items");
  ASSERT_FALSE(finished.empty());
  EXPECT_EQ(finished[0].at("interval"), json({0.5, 1.5}));
  const fs::path file = folder_ / "diagnosis.json";
  json record = json::parse(ReadTextFile(file));
  record["verdict"] = "interrupted";
  for (json& parameter : record["answer"]["parameters"])
    parameter["interval90"] = {nullptr, nullptr};
  WriteWholeFile(file, record.dump());
  const json data = DataOfPage(MakeReport(folder_, kTestAssets).html);
  int checked = 0;
  for (const json& section : data.at("sections")) {
    if (section.at("id") != "parameters") continue;
    ++checked;
    for (const json& item : section.at("blocks")[0].at("items"))
      EXPECT_TRUE(item.at("interval").is_null()) << item;
    EXPECT_EQ(section.at("blocks")[0].at("items")[0].at("value"), 1.0);
    EXPECT_THAT(section.at("lead").get<std::string>(), HasSubstr("without intervals"));
  }
  EXPECT_EQ(checked, 1);
}

}  // namespace
}  // namespace clothfit
