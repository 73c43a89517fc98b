// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit fit A B ...
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;

// Recordings of one cloth, and the fit of two with a third one held out, made once for all tests.
class FitSeveral : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    for (const auto& [name, frames] :
         std::map<std::string, int>{{"a/take", 16}, {"b/take", 13}, {"c", 10}}) {
      SmallRecordingOptions options;
      options.particles = 5;
      options.frames = frames;
      WriteRecording(MakeSmallRecording(options), folder_->path() / name);
    }
    result_ = new CommandResult(Fit({"a/take", "b/take", "--hold-out", "c", "-o", "run"}));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete folder_;
  }

  static CommandResult Fit(std::vector<std::string> words) {
    words.insert(words.begin(), "fit");
    for (const char* fixed : {"stretch", "shear", "bending.damping", "air_drag.tangential"}) {
      words.push_back("--fix");
      words.push_back(fixed);
    }
    return RunCommand(words, folder_->path());
  }
  static const fs::path& path() { return folder_->path(); }

  static TestFolder* folder_;
  static CommandResult* result_;
};
TestFolder* FitSeveral::folder_ = nullptr;
CommandResult* FitSeveral::result_ = nullptr;

TEST_F(FitSeveral, FindsTheMaterialAndPredictsWhatIsHeldOut) {
  ASSERT_EQ(result_->status, 0) << result_->err;
  const json summary = json::parse(ReadTextFile(path() / "run" / "summary.json"));
  EXPECT_EQ(summary.at("status"), "converged");
  const json& drag = summary.at("parameters").at("air_drag.normal");
  EXPECT_LT(drag.at("interval")[0], 2.5);
  EXPECT_GT(drag.at("interval")[1], 2.5);
  const json& recordings = summary.at("recordings");
  ASSERT_EQ(recordings.size(), 3u);
  EXPECT_EQ(recordings[0].at("name"), "take");
  EXPECT_EQ(recordings[1].at("name"), "take-2");  // another folder of this name
  EXPECT_EQ(recordings[2].at("name"), "c");
  EXPECT_EQ(recordings[2].at("held_out_whole"), true);
  EXPECT_TRUE(recordings[2].at("fit").at("marker_rms_m").is_null());
  const double noise = 0.0005 * std::sqrt(3.0);
  EXPECT_NEAR(recordings[2].at("held_out").at("marker_rms_m"), noise, 0.3 * noise);
  EXPECT_GT(recordings[2].at("before").at("held_out").at("marker_rms_m"), 1.3 * noise);
  for (const char* word :
       {"take-2", "markers, held out", "air_drag.normal", "which was not fitted"})
    EXPECT_THAT(result_->out, HasSubstr(word));
  EXPECT_THAT(result_->err, HasSubstr("all frames of 2 recordings"));
}

TEST_F(FitSeveral, LeavesRunsThatOtherCommandsRead) {
  folder_->Write("points.csv", "frame,u,v\n9,0.4,0.4\n");
  for (const char* name : {"take", "take-2", "c"}) {
    const std::string run = (fs::path("run/recordings") / name).string();
    const std::string out = std::string(name) + ".csv", picture = std::string(name) + ".png";
    EXPECT_EQ(RunCommand({"predict", run, "--at", "points.csv", "-o", out}, path()).status, 0);
    EXPECT_EQ(RunCommand({"draw", run, "-o", picture}, path()).status, 0);
  }
  const std::string line =
      BadInputLine(RunCommand({"predict", "run", "--at", "points.csv", "-o", "whole.csv"}, path()));
  EXPECT_THAT(line, HasSubstr("run: is a fit of several recordings; expected the run of one"));
}

TEST_F(FitSeveral, HasAReportThatLeadsToThoseOfEach) {
  const CommandResult result = RunCommand({"report", "run", "-o", "page.html"}, path());
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string page = ReadTextFile(path() / "page.html");
  EXPECT_THAT(page, HasSubstr("3 recordings of one cloth"));
  for (const char* name : {"take", "take-2", "c"}) {
    const std::string place = "run/recordings/" + std::string(name) + "/report.html";
    EXPECT_TRUE(fs::exists(path() / place));
    EXPECT_THAT(page, HasSubstr("./" + place));
  }
  EXPECT_THAT(BadInputLine(RunCommand({"report", "run", "-o", "other.html"}, path())),
              HasSubstr("report.html: exists already"));
}

TEST_F(FitSeveral, RefusesAllForOneBeforeAnythingIsWritten) {
  fs::copy(path() / "a" / "take", path() / "bad", fs::copy_options::recursive);
  folder_->Write("bad/markers.csv", "frame,id,u,v,x,y,z\n0,0,0.1,0.1,0,0,zero\n");
  EXPECT_THAT(BadInputLine(Fit({"a/take", "b/take", "bad", "-o", "none"})),
              HasSubstr("bad/markers.csv: line 2"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "b/take", "--hold-out", "bad", "-o", "none"})),
              HasSubstr("bad/markers.csv: line 2"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "gone", "-o", "none"})), HasSubstr("gone"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "a/take", "-o", "none"})), HasSubstr("named twice"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "b/take"})), HasSubstr("-o"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "b/take", "-o", "none", "--optimiser", "bobyqa"})),
              HasSubstr("several recordings are fitted by lm"));
  EXPECT_THAT(BadInputLine(Fit({"a/take", "b/take", "-o", "none", "--finest", "9"})),
              HasSubstr("--finest: is for one recording"));
  EXPECT_FALSE(fs::exists(path() / "none"));
}

TEST_F(FitSeveral, ResumesWithItsOwnRecordingsOnly) {
  const std::vector<std::string> fit = {"a/take", "c", "-o", "short", "--max-iterations", "1"};
  ASSERT_EQ(Fit(fit).status, 0);
  EXPECT_THAT(
      BadInputLine(RunCommand({"fit", "a/take", "b/take", "--resume", "-o", "short"}, path())),
      HasSubstr("the recordings differ from those of the run"));
  EXPECT_THAT(
      BadInputLine(RunCommand({"fit", "--resume", "-o", "short", "--window", "0.3"}, path())),
      HasSubstr("differ from those of the run: strategy.window"));
  const CommandResult more =
      RunCommand({"fit", "--resume", "-o", "short", "--max-iterations", "3"}, path());
  ASSERT_EQ(more.status, 0) << more.err;
  std::vector<std::string> at_once = fit;
  at_once[3] = "three";
  at_once.back() = "3";
  ASSERT_EQ(Fit(at_once).status, 0);
  for (const char* file :
       {"parameters.yaml", "recordings/c/parameters.yaml", "recordings/take/trajectory.npy"})
    EXPECT_EQ(ReadTextFile(path() / "short" / file), ReadTextFile(path() / "three" / file)) << file;
}

}  // namespace
}  // namespace clothfit
