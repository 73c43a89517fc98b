// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import: what is made can be used, and nothing is replaced without being asked to.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "tests/apps/command.h"
#include "tests/support/motive_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

const char* const kModelCameras = "1 PINHOLE 64 48 50 50 32 24\n";
const char* const kModelImages =
    "1 1 0 0 0 0 0 2 1 left.png\n\n"
    "2 1 0 0 0 0.5 0 2 1 right.png\n\n";

class ImportCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<Eigen::Vector2d> uv;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) uv.emplace_back(0.1 * column, 0.09 * row);
    }
    folder_.Write("take.csv", MotiveCsv(BentSheetTake(uv, 1e-4), "Millimeters", 1e-3));
    folder_.Write("model/cameras.txt", kModelCameras);
    folder_.Write("model/images.txt", kModelImages);
  }

  CommandResult Import(std::vector<std::string> words) const {
    words.insert(words.begin(), "import");
    return RunCommand(words, path());
  }

  void WriteVideo(const std::string& name, int frame_count) const {
    cv::VideoWriter writer((path() / name).string(), cv::CAP_OPENCV_MJPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25.0, cv::Size(64, 48));
    for (int i = 0; i < frame_count; ++i) {
      writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(9)));
    }
  }

  const fs::path& path() const { return folder_.path(); }

  TestFolder folder_;
};

TEST_F(ImportCommand, MakesARecordingOfATakeThatCanBeFitted) {
  const CommandResult result =
      Import({"markers", "take.csv", "-o", "rec/", "--handles", "left=m0,right=m3", "--held-out",
              "0.2", "--resolution", "5", "4", "--margin", "0.01"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("60 frames at 120 Hz, 10 markers, 2 handles"));
  EXPECT_THAT(result.out, HasSubstr("4 x 3 markers sit on a grid"));
  EXPECT_THAT(result.out, HasSubstr("layout: rms"));
  EXPECT_THAT(result.out, HasSubstr("\nname,u,v\nm0,"));
  EXPECT_THAT(ReadTextFile(path() / "rec" / "recording.yaml"), HasSubstr("name: rec\n"));
  const CommandResult check = RunCommand({"check", "rec"}, path());
  EXPECT_EQ(check.status, 0) << check.err;
  const CommandResult fit =
      RunCommand({"fit", "rec", "-o", "run", "--max-iterations", "0", "--quiet"}, path());
  EXPECT_EQ(fit.status, 0) << fit.err;
}

TEST_F(ImportCommand, GoesByTheContentOfAFile) {
  std::string table = "time,a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z,d_x,d_y,d_z\n";
  for (int frame = 0; frame < 5; ++frame) {
    table += fmt::format("{},0,0,0,300,0,0,0,300,{},300,300,0\n", 0.01 * frame, frame);
  }
  folder_.Write("take.dat", table);
  EXPECT_THAT(BadInputLine(Import({"markers", "take.dat", "-o", "rec"})),
              HasSubstr("take.dat: does not say all that is needed: expected --unit (m, cm or mm), "
                        "--up (the axis"));
  EXPECT_THAT(BadInputLine(Import({"markers", "take.dat", "-o", "rec", "--unit", "in"})),
              HasSubstr("--unit"));
  const CommandResult result =
      Import({"motive", "take.dat", "-o", "rec", "--unit", "mm", "--up=-y", "--handle", "none"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("5 frames at 100 Hz, 4 markers, 0 handles"));
  const Recording recording = ReadRecording(path() / "rec");
  ASSERT_EQ(recording.markers.size(), 20u);
  // What was (0, 300, 4) mm at the last frame.
  EXPECT_NEAR(recording.markers[18].position.z(), -0.3, 1e-9);
  EXPECT_THAT(BadInputLine(Import(
                  {"markers", "take.dat", "-o", "rec", "--unit", "mm", "--up", "v", "--force"})),
              HasSubstr("--up: expected x, y, z, -x, -y or -z, found 'v'"));
}

TEST_F(ImportCommand, LayoutOfATakeServesOthers) {
  ASSERT_EQ(Import({"markers", "take.csv", "-o", "a"}).status, 0);
  const std::string layout = (path() / "a" / "layout.csv").string();
  ASSERT_EQ(Import({"markers", "take.csv", "-o", "b", "--layout", layout}).status, 0);
  EXPECT_EQ(ReadTextFile(path() / "a" / "markers.csv"), ReadTextFile(path() / "b" / "markers.csv"));
}

TEST_F(ImportCommand, RefusesBadTakes) {
  EXPECT_THAT(BadInputLine(Import({"markers", "gone.csv", "-o", "rec"})),
              HasSubstr("gone.csv: no such file"));
  EXPECT_THAT(BadInputLine(Import({"markers", "take.csv", "-o", "rec", "--handle", "mo"})),
              HasSubstr("--handle: 'mo' is no marker of take.csv; did you mean 'm0'?"));
  folder_.Write("layout.csv", "name,u,v\nm0,0,0\n");
  EXPECT_THAT(BadInputLine(Import({"markers", "take.csv", "-o", "rec", "--layout", "layout.csv"})),
              HasSubstr("layout.csv: marker 'm1' of take.csv is missing"));
  EXPECT_THAT(BadInputLine(Import({"markers", "take.csv", "-o", "rec", "--hande", "m0"})),
              HasSubstr("--hande: did you mean '--handle'?"));
  EXPECT_THAT(BadInputLine(Import({"mrakers", "take.csv", "-o", "rec"})),
              HasSubstr("mrakers: did you mean 'markers'?"));
  EXPECT_FALSE(fs::exists(path() / "rec"));
  folder_.Write("rec/recording.yaml", "mine");
  EXPECT_THAT(BadInputLine(Import({"markers", "take.csv", "-o", "rec"})),
              HasSubstr("recording.yaml: exists already and is not replaced"));
  EXPECT_EQ(ReadTextFile(path() / "rec" / "recording.yaml"), "mine");
}

TEST_F(ImportCommand, PutsCamerasAndVideosTogether) {
  WriteVideo("a.avi", 3);
  WriteVideo("b.avi", 4);
  const CommandResult cameras =
      Import({"colmap", "model", "-o", "rec", "--scale", "0.5", "--up=-y"});
  ASSERT_EQ(cameras.status, 0) << cameras.err;
  EXPECT_THAT(cameras.out, HasSubstr("cameras.yaml: 2 cameras"));
  EXPECT_THAT(cameras.out, HasSubstr("left: 64 x 48 px, at (0.000, -1.000, 0.000) m"));
  EXPECT_THAT(cameras.out,
              HasSubstr("it needs --size, --frames, --rate, --ground, --origin or --corner"));
  EXPECT_THAT(cameras.out,
              testing::EndsWith("\nnext: clothfit import video CAMERA=FILE ... -o rec\n"));
  EXPECT_THAT(BadInputLine(Import({"video", "left=a.avi", "-o", "rec", "--handle", "hand=0"})),
              HasSubstr("--handle: expected NAME=U,V such as left=0,0, found 'hand=0'"));
  const CommandResult videos = Import(
      {"video",    "left=a.avi",   "right=b.avi", "-o",  "rec",        "--size", "0.4", "0.3",
       "--origin", "-0.2",         "-0.1",        "1",   "--v-axis",   "0",      "0",   "-1",
       "--handle", "hand=0.4,0.3", "--density",   "0.2", "--held-out", "0.25"});
  ASSERT_EQ(videos.status, 0) << videos.err;
  EXPECT_THAT(videos.out, HasSubstr("2 cameras, 4 frames at 25 Hz"));
  EXPECT_THAT(videos.out, Not(HasSubstr("not written")));
  EXPECT_THAT(videos.out, testing::EndsWith("\nnext: clothfit check rec\n"));
  const Recording recording = ReadRecording(path() / "rec");
  EXPECT_EQ(recording.frame_count, 4);
  EXPECT_EQ(std::get<FlatPlacement>(recording.cloth.initial).origin,
            Eigen::Vector3d(-0.2, -0.1, 1.0));
  ASSERT_EQ(recording.handles.size(), 1u);
  EXPECT_EQ(recording.handles[0].uv, Eigen::Vector2d(0.4, 0.3));
  EXPECT_EQ(recording.cloth.areal_density, 0.2);
  ASSERT_TRUE(recording.splits.held_out_frames);
  EXPECT_EQ(recording.splits.held_out_frames->first, 3);
  EXPECT_THAT(
      BadInputLine(Import({"video", "left=a.avi", "-o", "rec", "--density", "1"})),
      HasSubstr("recording.yaml: exists already; expected no options that describe the scene"));
  EXPECT_THAT(BadInputLine(Import({"video", "left=a.avi", "-o", "rec", "--size", "1", "1"})),
              HasSubstr("expected no options that describe the scene"));
  EXPECT_EQ(Import({"video", "left=a.avi", "-o", "rec"}).status, 0) << "the same again";
  EXPECT_THAT(BadInputLine(Import({"video", "left=b.avi", "-o", "rec"})),
              HasSubstr("left.avi: exists already; --force replaces it"));
  EXPECT_THAT(BadInputLine(Import({"colmap", "model", "-o", "rec"})),
              HasSubstr("cameras.yaml: exists already; --force replaces it"));
  EXPECT_EQ(Import({"colmap", "model", "-o", "rec", "--force"}).status, 0);
}

// The cameras look along y, 0.5 m apart; the sheet hangs 2 m before them.
TEST_F(ImportCommand, PlacesAClothByItsCornersInPictures) {
  WriteVideo("a.avi", 3);
  WriteVideo("b.avi", 3);
  std::vector<std::string> words = {"video",  "left=a.avi", "right=b.avi", "-o",       "rec",
                                    "--size", "0.4",        "0.4",         "--corner", "left",
                                    "0",      "0",          "21.5",        "13.5"};
  EXPECT_THAT(BadInputLine(Import(words)), HasSubstr("cameras.yaml: no such file"));
  ASSERT_EQ(Import({"colmap", "model", "-o", "rec", "--up=-y"}).status, 0);
  EXPECT_THAT(BadInputLine(Import(words)), HasSubstr("--corner: expected three corners that two"));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--corner", "right", "0", "0", "34", "13.5"},
        {"--corner", "left", "0.4", "0", "31.5", "13.5"},
        {"--corner", "right", "0.4", "0", "44", "13.5"}}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  const CommandResult result = Import(words);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("corner (0.4, 0): at ("));
  EXPECT_THAT(result.out, HasSubstr("taken to hang straight down"));
  const auto flat = std::get<FlatPlacement>(ReadRecording(path() / "rec").cloth.initial);
  EXPECT_LT((flat.v_axis + Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(std::abs(flat.u_axis.x()), 1.0, 1e-6);
  words[1] = "right=a.avi";
  EXPECT_THAT(BadInputLine(Import(words)),
              HasSubstr("exists already; expected no options that describe"));
}

TEST_F(ImportCommand, BeginsARecordingOfOpencvCameras) {
  const std::string file =
      "%YAML:1.0\n---\nK: [50, 0, 32, 0, 50, 24, 0, 0, 1]\nR: [0, 0, 0]\nT: [0, 0, 2000]\n";
  folder_.Write("left.yml", file);
  folder_.Write("right.yml", file);
  const std::vector<std::string> words = {"opencv",  "left.yml", "right.yml",    "-o",       "rec",
                                          "--scale", "0.001",    "--image-size", "64",       "48",
                                          "--size",  "0.4",      "0.3",          "--ground", "0",
                                          "--rate",  "30",       "--frames",     "7"};
  const CommandResult result = Import(words);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("right: 64 x 48 px, at (0.000, 0.000, -2.000) m"));
  EXPECT_THAT(ReadTextFile(path() / "rec" / "recording.yaml"), HasSubstr("frame_count: 7\n"));
  EXPECT_THAT(BadInputLine(Import(words)),
              HasSubstr("expected no options that describe the scene"));
}

TEST_F(ImportCommand, RefusesBadCamerasAndVideos) {
  folder_.Write("model/images.txt", "1 0 0 0 0 0 0 2 1 left.png\n\n");
  EXPECT_THAT(BadInputLine(Import({"colmap", "model", "-o", "rec"})),
              HasSubstr("images.txt: line 1: QW QX QY QZ: expected a rotation"));
  folder_.Write("model/images.txt", kModelImages);
  EXPECT_THAT(BadInputLine(Import({"colmap", "model", "-o", "rec", "--up", "w"})),
              HasSubstr("--up: expected x, y, z, -x, -y or -z, found 'w'"));
  folder_.Write("cam.yml", "%YAML:1.0\n---\nK: [1]\n");
  EXPECT_THAT(BadInputLine(Import({"opencv", "cam.yml", "-o", "rec"})),
              HasSubstr("cam.yml: K: expected the 3 x 3 numbers"));
  EXPECT_THAT(BadInputLine(Import({"opencv", "take.csv", "-o", "rec"})), HasSubstr("take.csv"));
  EXPECT_THAT(BadInputLine(Import({"video", "a.avi", "-o", "rec"})),
              HasSubstr("a.avi: expected CAMERA=FILE"));
  EXPECT_THAT(BadInputLine(Import({"video", "left=take.csv", "-o", "rec"})),
              HasSubstr("take.csv: cannot be read as a video"));
  EXPECT_FALSE(fs::exists(path() / "rec"));
}

}  // namespace
}  // namespace clothfit
