// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From a recording to a run, and from a run to predictions.
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "fitting/runs/run_folder.h"
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::HasSubstr;

// A run with two free parameters, made once for all tests of this file.
class FitCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    SmallRecordingOptions options;
    options.particles = 5;
    options.frames = 20;
    WriteRecording(MakeSmallRecording(options), folder_->path() / "rec");
    result_ = new CommandResult(Fit("run"));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete folder_;
  }

  static CommandResult Fit(const std::string& run, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"fit",    "rec",
                                      "-o",     run,
                                      "--fix",  "stretch",
                                      "--fix",  "shear",
                                      "--fix",  "bending",
                                      "--free", "bending.stiffness",
                                      "--fix",  "air_drag.tangential"};
    words.insert(words.end(), more.begin(), more.end());
    return RunCommand(words, folder_->path());
  }
  static json Summary(const std::string& run) {
    return json::parse(ReadTextFile(folder_->path() / run / "summary.json"));
  }

  static const fs::path& path() { return folder_->path(); }

  static TestFolder* folder_;
  static CommandResult* result_;
};
TestFolder* FitCommand::folder_ = nullptr;
CommandResult* FitCommand::result_ = nullptr;

TEST_F(FitCommand, RecoversTheParametersThatMadeTheRecording) {
  ASSERT_EQ(result_->status, 0) << result_->err;
  // what a person who waits wants to know
  for (const char* word : {"frames", "iteration", "cost", "error", "simulations"})
    EXPECT_THAT(result_->err, HasSubstr(word));
  const json summary = Summary("run");
  EXPECT_EQ(summary.at("status"), "converged");
  const json& drag = summary.at("parameters").at("air_drag.normal");
  EXPECT_NEAR(drag.at("value"), 2.5, 0.05);  // some sigmas of the markers' noise
  EXPECT_EQ(drag.at("start"), DefaultConfig({}).parameters.at("air_drag.normal").value);
  EXPECT_TRUE(drag.at("free"));
  EXPECT_LT(drag.at("interval")[0], drag.at("value"));
  EXPECT_GT(drag.at("interval")[1], drag.at("value"));
  const json& bending = summary.at("parameters").at("bending.stiffness").at("interval");
  EXPECT_LT(bending[0], 1e-4);
  EXPECT_GT(bending[1], 1e-4);
  EXPECT_LT(bending[1].get<double>() / bending[0].get<double>(), 2.0);
  EXPECT_TRUE(summary.at("parameters").at("stretch.stiffness").at("interval").is_null());
  // Distances of points whose coordinates have a noise of 0.5 mm.
  EXPECT_NEAR(summary.at("fit").at("marker_rms_m"), 0.0005 * std::sqrt(3.0), 1e-4);
  EXPECT_NEAR(summary.at("held_out").at("marker_rms_m"), 0.0005 * std::sqrt(3.0), 3e-4);
  EXPECT_GT(summary.at("before").at("fit").at("marker_rms_m"), 0.002);
  EXPECT_TRUE(summary.at("fit").at("track_rms_px").is_null());
  EXPECT_EQ(summary.at("clothfit"), CLOTHFIT_VERSION);
}

TEST_F(FitCommand, PrintsErrorsAndEstimates) {
  EXPECT_THAT(result_->out, HasSubstr("markers, fitted"));
  EXPECT_THAT(result_->out, HasSubstr("markers, held out"));
  EXPECT_THAT(result_->out, testing::ContainsRegex("air_drag.normal +[0-9.]+ +2\\.[45]"));
  EXPECT_THAT(result_->out, testing::Not(HasSubstr("stretch.stiffness   ")));  // it is fixed
  EXPECT_THAT(result_->err, HasSubstr("all frames (0-15)"));  // no terminal: plain lines
  EXPECT_THAT(result_->err, testing::Not(HasSubstr("\r")));
}

TEST_F(FitCommand, WritesACompleteRun) {
  for (const char* name : {"config.yaml", "parameters.yaml", "summary.json", "trajectory.npy",
                           "mesh.obj", "residuals.csv", "log.txt"}) {
    EXPECT_TRUE(fs::exists(path() / "run" / name)) << name;
  }
  EXPECT_FALSE(fs::exists(path() / "run" / "checkpoint.bin"));  // nothing is left to do
  for (const fs::directory_entry& entry : fs::directory_iterator(path() / "run")) {
    EXPECT_NE(entry.path().extension(), ".part");
  }
}

TEST_F(FitCommand, CanBeRepeatedFromItsOwnConfig) {
  const CommandResult again =
      RunCommand({"fit", "--config", "run/config.yaml", "-o", "again", "--quiet"}, path());
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.out + again.err, "");
  EXPECT_EQ(ReadTextFile(path() / "again" / "config.yaml"),
            ReadTextFile(path() / "run" / "config.yaml"));
  EXPECT_EQ(ReadTextFile(path() / "again" / "parameters.yaml"),
            ReadTextFile(path() / "run" / "parameters.yaml"));
}

TEST_F(FitCommand, NeverOverwritesWithoutForceNorWhatIsNoRun) {
  const std::string before = ReadTextFile(path() / "run" / "summary.json");
  EXPECT_THAT(BadInputLine(Fit("run")), HasSubstr("run: already holds a run; --force replaces it"));
  EXPECT_EQ(ReadTextFile(path() / "run" / "summary.json"), before);

  folder_->Write("mine/config.yaml", "of my own\n");
  folder_->Write("mine/log.txt", "also of my own\n");
  EXPECT_THAT(BadInputLine(Fit("mine")), HasSubstr("mine: is not empty"));
  EXPECT_THAT(BadInputLine(Fit("mine", {"--force"})),
              HasSubstr("mine: is not the folder of a run"));
  EXPECT_EQ(ReadTextFile(path() / "mine" / "config.yaml"), "of my own\n");

  ASSERT_EQ(Fit("forced", {"--max-iterations", "0"}).status, 0);
  folder_->Write("forced/notes.txt", "keep\n");
  EXPECT_EQ(Fit("forced", {"--max-iterations", "1", "--force"}).status, 0);
  EXPECT_EQ(ReadTextFile(path() / "forced" / "notes.txt"), "keep\n");
  EXPECT_EQ(BadInputLine(Fit("run", {"--force", "--set", "nonsense=1"})).find("run:"),
            std::string::npos);
  EXPECT_EQ(ReadTextFile(path() / "run" / "summary.json"), before);  // checked before replacing
}

TEST_F(FitCommand, WarnsWhenIterationsRunOut) {
  const CommandResult result = Fit("short", {"--max-iterations", "1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("warning: not converged; 'clothfit fit --resume -o short "));
  EXPECT_EQ(Summary("short").at("status"), "not converged");
  // With more of them it becomes the fit that was given as many from the start on.
  const CommandResult more =
      RunCommand({"fit", "--resume", "-o", "short", "--quiet", "--max-iterations", "3"}, path());
  ASSERT_EQ(more.status, 0) << more.err;
  ASSERT_EQ(Fit("three", {"--max-iterations", "3"}).status, 0);
  for (const char* file : {"parameters.yaml", "trajectory.npy", "residuals.csv"})
    EXPECT_EQ(ReadTextFile(path() / "short" / file), ReadTextFile(path() / "three" / file)) << file;
}

TEST_F(FitCommand, FindsTheRunsFolderByTheRecordingsName) {
  const CommandResult result =
      RunCommand({"fit", "rec", "--max-iterations", "0", "--initial-order", "-1"}, path());
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(fs::exists(path() / "runs" / "small" / "summary.json"));
}

struct Predicted {
  int frame;
  Eigen::Vector2d uv;
  Eigen::Vector3d position;
};

std::vector<Predicted> ReadPredictions(const fs::path& file) {
  std::vector<Predicted> rows;
  ReadCsv(file, {"frame", "u", "v", "x", "y", "z"}, [&](const CsvRow& row) {
    rows.push_back({row.Integer(0), row.Vector2(1), row.Vector3(3)});
  });
  return rows;
}

TEST_F(FitCommand, PredictsAnyPointInAnyFrameInTheOrderAsked) {
  folder_->Write("points.csv", "frame,u,v\n19,0.4,0.4\n0,0.1,0.2\n7,0.03,0.31\n7,0,0\n");
  const CommandResult result =
      RunCommand({"predict", "run", "--at", "points.csv", "-o", "out.csv"}, path());
  ASSERT_EQ(result.status, 0) << result.err;
  const std::vector<Predicted> rows = ReadPredictions(path() / "out.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].frame, 19);
  EXPECT_EQ(rows[2].uv, Eigen::Vector2d(0.03, 0.31));
  // At frame 0 the cloth lies flat at a height of 1 m.
  EXPECT_LT((rows[1].position - Eigen::Vector3d(0.1, 0.2, 1.0)).norm(), 1e-9);
  // Frame 19 is held out; its last particle stands at the end of the trajectory.
  const std::string bytes = ReadTextFile(path() / "run" / "trajectory.npy");
  Eigen::Vector3d last;
  std::memcpy(last.data(), bytes.data() + bytes.size() - sizeof(last), sizeof(last));
  EXPECT_LT((rows[0].position - last).norm(), 1e-6);
  EXPECT_LT((rows[3].position - Eigen::Vector3d(0.0, 0.1 * (1 - std::cos(35.0 / 30)),
                                                1.0 + 0.05 * std::sin(35.0 / 30)))
                .norm(),
            1e-9);  // the handle's own path

  EXPECT_THAT(
      BadInputLine(RunCommand({"predict", "run", "--at", "points.csv", "-o", "out.csv"}, path())),
      HasSubstr("out.csv: exists already; --force replaces it"));
  EXPECT_EQ(RunCommand({"predict", "run", "--at", "points.csv", "-o", "out.csv", "--force"}, path())
                .status,
            0);
}

TEST_F(FitCommand, PredictRefusesWhatIsOutside) {
  const auto line_for = [&](const std::string& row) {
    folder_->Write("bad.csv", "frame,u,v\n0,0,0\n" + row + "\n");
    const std::string line = BadInputLine(
        RunCommand({"predict", "run", "--at", "bad.csv", "-o", "bad_out.csv"}, path()));
    EXPECT_FALSE(fs::exists(path() / "bad_out.csv"));
    return line;
  };
  EXPECT_THAT(line_for("3,0.5,0"), HasSubstr("bad.csv: line 3: u = 0.5 is outside the cloth"));
  EXPECT_THAT(line_for("3,0,-0.1"), HasSubstr("bad.csv: line 3: v = -0.1 is outside the cloth"));
  EXPECT_THAT(line_for("20,0,0"), HasSubstr("bad.csv: line 3: frame 20 is outside 0..19"));
  EXPECT_THAT(line_for("-1,0,0"), HasSubstr("bad.csv: line 3: frame -1 is outside 0..19"));
  EXPECT_THAT(line_for("1,nan,0"), HasSubstr("bad.csv: line 3: u: expected a finite number"));
  folder_->Write("empty.csv", "frame,u,v\n");
  EXPECT_THAT(BadInputLine(RunCommand({"predict", "run", "--at", "empty.csv", "-o", "x"}, path())),
              HasSubstr("empty.csv: holds no points"));
  EXPECT_THAT(BadInputLine(RunCommand({"predict", "rec", "--at", "empty.csv", "-o", "x"}, path())),
              HasSubstr("rec: is a recording; 'clothfit report rec' shows it, 'clothfit fit rec -o "
                        "RUN' makes a run of it"));
  EXPECT_THAT(BadInputLine(RunCommand({"predict", "gone", "--at", "empty.csv", "-o", "x"}, path())),
              HasSubstr("gone: no such folder"));
}

TEST_F(FitCommand, DrawsTheFitBeforeAndAfter) {
  const std::vector<std::string> words = {"draw", "run", "-o", "p.png", "--frames", "3", "19"};
  const CommandResult drawn = RunCommand(words, path());
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const cv::Mat picture = cv::imread((path() / "p.png").string());
  ASSERT_EQ(picture.size(), cv::Size(840, 840));  // two frames, two rows
  for (const cv::Rect& panel : {cv::Rect(0, 0, 420, 420), cv::Rect(420, 420, 420, 420)}) {
    cv::Mat grey;
    cv::cvtColor(picture(panel), grey, cv::COLOR_BGR2GRAY);
    const int covered = cv::countNonZero(grey < 200);
    EXPECT_GT(covered, 420 * 420 / 20) << "there is a cloth in it";
    EXPECT_LT(covered, 420 * 420 * 3 / 4) << "and room around it";
  }
  const CommandResult recording =
      RunCommand({"draw", "rec", "-o", "r.png", "--frames", "3", "9", "19"}, path());
  ASSERT_EQ(recording.status, 0) << recording.err;
  EXPECT_EQ(cv::imread((path() / "r.png").string()).size(), cv::Size(1260, 420));
  EXPECT_THAT(BadInputLine(RunCommand(words, path())), HasSubstr("--force"));
  EXPECT_THAT(BadInputLine(RunCommand({"draw", "run", "-o", "p.txt"}, path())),
              HasSubstr("p.txt: expected a name that ends in .png or .jpg"));
  EXPECT_THAT(BadInputLine(RunCommand({"draw", "run", "-o", "q.png", "--frames", "20"}, path())),
              HasSubstr("--frames"));
}

}  // namespace
}  // namespace clothfit
