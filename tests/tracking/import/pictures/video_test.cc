// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos and cameras put into folders that hold a recording, or do not yet.
#include "tracking/import/pictures/video.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "tests/support/test_folder.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class VideoImport : public testing::Test {
 protected:
  // Frame i is grey with value 40 * (i + 1).
  fs::path WriteVideo(const std::string& name, int frame_count, double rate = 25.0,
                      int width = 64) const {
    fs::path file = folder_.path() / name;
    cv::VideoWriter writer(file.string(), cv::CAP_OPENCV_MJPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate, cv::Size(width, 48));
    EXPECT_TRUE(writer.isOpened());
    for (int i = 0; i < frame_count; ++i) {
      writer.write(cv::Mat(48, width, CV_8UC3, cv::Scalar::all(40 * (i + 1))));
    }
    return file;
  }

  fs::path WritePicture(const std::string& name, int grey, int width = 64) const {
    fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    cv::imwrite(file.string(), cv::Mat(48, width, CV_8UC3, cv::Scalar::all(grey)));
    return file;
  }

  fs::path recording() const { return folder_.path() / "rec"; }

  static Camera CameraOf(const std::string& name) {
    Camera camera;
    camera.name = name;
    camera.width = 64;
    camera.height = 48;
    return camera;
  }

  void WriteCamerasOf(const std::vector<std::string>& names) const {
    std::vector<Camera> cameras;
    for (const std::string& name : names) cameras.push_back(CameraOf(name));
    OutputFolder folder = OpenRecording(recording(), "import cameras", Overwrite::kRefuse);
    WriteCameras(cameras, &folder);
  }

  std::string ErrorOf(const std::vector<NamedVideo>& videos,
                      Overwrite overwrite = Overwrite::kRefuse) const {
    return InputErrorOf([&] { ImportVideos(videos, {}, recording(), overwrite); });
  }

  static SceneStart LyingCloth() {
    SceneStart start;
    start.size = Eigen::Vector2d(0.5, 0.4);
    start.ground_height = 0.0;
    return start;
  }

  TestFolder folder_;
};

TEST_F(VideoImport, BeginsARecording) {
  const fs::path left = WriteVideo("GX01.avi", 5);
  const fs::path right = WriteVideo("GX02.avi", 4);
  WriteCamerasOf({"left", "right"});
  const ImportedVideos imported = ImportVideos({{"left", left}, {"right", right}}, LyingCloth(),
                                               recording(), Overwrite::kRefuse);
  EXPECT_EQ(imported.frame_count, 5);
  EXPECT_EQ(imported.frame_rate, 25.0);
  EXPECT_TRUE(fs::exists(left));
  const Recording read = ReadRecording(recording());
  EXPECT_EQ(read.name, "rec");
  EXPECT_EQ(read.frame_count, 5);
  EXPECT_EQ(read.frame_rate, 25.0);
  EXPECT_EQ(read.cloth.size, Eigen::Vector2d(0.5, 0.4));
  EXPECT_EQ(read.ground_height, 0.0);
  EXPECT_NEAR(LoadImage(read, 0, 3).at<cv::Vec3b>(5, 5)[0], 160, 4);  // JPEG is lossy
  EXPECT_TRUE(LoadImage(read, 1, 4).empty());
  EXPECT_EQ(ReadTextFile(recording() / "videos" / "left.avi"), ReadTextFile(left));
}

TEST_F(VideoImport, WritesWhatNoVideoSays) {
  const fs::path video = WriteVideo("a.avi", 5), empty = WritePicture("empty.png", 7);
  WriteCamerasOf({"left"});
  SceneStart start = LyingCloth();
  start.areal_density = 0.18;
  start.held_out_share = 0.4;
  start.handles.resize(1);
  start.handles[0].name = "hand";
  start.handles[0].uv = {0.5, 0.0};
  for (int i = 0; i < 2; ++i) {  // the second time the same again
    ImportVideos({{"left", video}}, start, recording(), Overwrite::kRefuse, {{"left", empty}});
  }
  const Recording read = ReadRecording(recording());
  EXPECT_EQ(read.cloth.areal_density, 0.18);
  ASSERT_TRUE(read.splits.held_out_frames);
  EXPECT_EQ(read.splits.held_out_frames->first, 3);
  EXPECT_EQ(read.splits.held_out_frames->last, 4);
  ASSERT_EQ(read.handles.size(), 1u);
  EXPECT_EQ(read.handles[0].name, "hand");
  EXPECT_EQ(read.handles[0].uv, Eigen::Vector2d(0.5, 0.0));
  EXPECT_FALSE(read.handles[0].path);
  EXPECT_EQ(LoadBackground(read, 0).at<cv::Vec3b>(5, 5)[0], 7);
}

TEST_F(VideoImport, RefusesWhatNoVideoSaysWhereItIsWrong) {
  const fs::path video = WriteVideo("a.avi", 5), empty = WritePicture("empty.png", 7);
  const auto error_of = [&](const SceneStart& start, const std::vector<NamedVideo>& backgrounds) {
    return InputErrorOf([&] {
      ImportVideos({{"left", video}}, start, recording(), Overwrite::kRefuse, backgrounds);
    });
  };
  EXPECT_THAT(error_of({}, {{"lfet", empty}}),
              HasSubstr("--background: 'lfet' is none of the cameras here; did you mean 'left'?"));
  EXPECT_THAT(error_of({}, {{"left", WritePicture("wide.png", 7, 65)}}),
              HasSubstr("wide.png: expected 64 x 48 px as its camera's video, found 65 x 48"));
  EXPECT_THAT(error_of({}, {{"left", video}}), HasSubstr("a.avi: cannot be read as a PNG"));
  EXPECT_THAT(error_of({}, {{"left", empty}, {"left", empty}}),
              HasSubstr("'left' has two backgrounds"));
  SceneStart start = LyingCloth();
  start.held_out_share = 1.0;
  EXPECT_THAT(error_of(start, {}), HasSubstr("--held-out: expected 0 to less than 1, found 1"));
  start.held_out_share = 0.0;
  start.handles.resize(1);
  start.handles[0].name = "hand";
  start.handles[0].uv = {0.6, 0.0};
  EXPECT_THAT(error_of(start, {}),
              HasSubstr("handles[0].uv: u = 0.6 is outside the cloth, 0..0.5"));
  EXPECT_FALSE(fs::exists(recording()));
}

TEST_F(VideoImport, TakesFoldersOfPictures) {
  WriteCamerasOf({"left", "right"});
  for (int i = 1; i <= 4; ++i) WritePicture("l/" + std::to_string(i) + ".png", 10 * i);
  for (const int i : {2, 3, 5}) WritePicture("r/shot_00" + std::to_string(i) + ".PNG", 20 * i);
  folder_.Write("l/notes.txt", "mine");
  const std::vector<NamedVideo> both = {{"left", folder_.path() / "l"},
                                        {"right", folder_.path() / "r"}};
  EXPECT_THAT(ErrorOf(both), HasSubstr("l: does not say its frame rate; expected --rate"));
  SceneStart start = LyingCloth();
  start.frame_rate = 30.0;
  const ImportedVideos imported = ImportVideos(both, start, recording(), Overwrite::kRefuse);
  EXPECT_EQ(imported.frame_count, 5);
  EXPECT_THAT(imported.notes, testing::Contains("right: 3 pictures; number 1 is frame 0"));
  const Recording read = ReadRecording(recording());
  EXPECT_EQ(read.frame_count, 5);
  EXPECT_EQ(LoadImage(read, 0, 3).at<cv::Vec3b>(5, 5)[0], 40);
  EXPECT_EQ(LoadImage(read, 1, 4).at<cv::Vec3b>(5, 5)[0], 100);
  EXPECT_TRUE(LoadImage(read, 1, 0).empty());
  ImportVideos(both, {}, recording(), Overwrite::kRefuse);  // the same again

  WritePicture("l/2.png", 200);
  fs::remove(folder_.path() / "l" / "4.png");
  EXPECT_THAT(ErrorOf(both), HasSubstr("000001.png: exists already; --force replaces it"));
  ImportVideos(both, {}, recording(), Overwrite::kAllow);
  EXPECT_EQ(LoadImage(ReadRecording(recording()), 0, 1).at<cv::Vec3b>(5, 5)[0], 200);
  EXPECT_FALSE(fs::exists(recording() / "images" / "left" / "000003.png"));
}

TEST_F(VideoImport, RefusesBrokenFoldersOfPictures) {
  const auto error_of = [&](const std::map<std::string, std::string>& files) {
    fs::remove_all(folder_.path() / "l");
    fs::create_directories(folder_.path() / "l");
    for (const auto& [name, bytes] : files) folder_.Write("l/" + name, bytes);
    return ErrorOf({{"left", folder_.path() / "l"}});
  };
  std::vector<unsigned char> small, large;
  cv::imencode(".png", cv::Mat(48, 64, CV_8UC3), small);
  cv::imencode(".png", cv::Mat(48, 65, CV_8UC3), large);
  const std::string png(small.begin(), small.end()), other(large.begin(), large.end());
  EXPECT_THAT(error_of({{"a.jpg", "x"}}),
              HasSubstr("l: expected pictures such as 000001.png, found none"));
  EXPECT_THAT(error_of({{"one.png", png}}), HasSubstr("one.png: expected a name that ends in a"));
  EXPECT_THAT(error_of({{"1.png", png.substr(0, 40)}}), HasSubstr("cannot be read as a PNG"));
  EXPECT_THAT(error_of({{"01.png", png}, {"1.png", png}}), HasSubstr("has the number of 01.png"));
  EXPECT_THAT(error_of({{"1.png", png}, {"2.png", other}}),
              HasSubstr("2.png: expected 64 x 48 px as the first one, found 65 x 48"));
  EXPECT_FALSE(fs::exists(recording()));
}

TEST_F(VideoImport, SaysWhatARecordingStillNeeds) {
  EXPECT_EQ(JoinNames(MissingOptions({})),
            "--size, --frames, --rate, --ground, --origin or --corner");
  SceneStart start = LyingCloth();
  EXPECT_EQ(JoinNames(MissingOptions(start)), "--frames, --rate");
  ImportVideos({{"left", WriteVideo("a.avi", 3)}}, {}, recording(), Overwrite::kRefuse);
  EXPECT_TRUE(fs::exists(recording() / "videos" / "left.avi"));
  EXPECT_FALSE(fs::exists(recording() / "recording.yaml"));
}

TEST_F(VideoImport, ChecksARecordingThatIsThere) {
  const fs::path file = WriteVideo("a.avi", 5);
  const auto with_scene = [&](const std::string& rate, const std::string& count) {
    folder_.Write("rec/recording.yaml",
                  "frame_rate: " + rate + "   # Hz\nframe_count: " + count + "\nname: x\n");
  };
  with_scene("25", "9");
  ImportVideos({{"left", file}}, {}, recording(), Overwrite::kRefuse);  // a video may end earlier
  fs::remove_all(recording() / "videos");
  with_scene("30", "9");
  EXPECT_THAT(ErrorOf({{"left", file}}),
              HasSubstr("recording.yaml: frame_rate: 30, but the videos have 5 frames at 25 Hz"));
  with_scene("25", "4");
  EXPECT_THAT(ErrorOf({{"left", file}}),
              HasSubstr("recording.yaml: frame_count: 4, but the videos have 5 frames at 25 Hz; "
                        "--force sets it"));
  EXPECT_FALSE(fs::exists(recording() / "videos"));
  with_scene("30", "4");
  ImportVideos({{"left", file}}, {}, recording(), Overwrite::kAllow);
  EXPECT_EQ(ReadTextFile(recording() / "recording.yaml"),
            "frame_rate: 25 # Hz\nframe_count: 5\nname: x\n");
  EXPECT_FALSE(ReadManifest(recording())->Lists("recording.yaml"));  // made by hand all the same
}

TEST_F(VideoImport, OverwritesNothingUnlessAllowed) {
  const fs::path first = WriteVideo("a.avi", 3);
  const fs::path second = WriteVideo("b.avi", 4);
  folder_.Write("rec/videos/left.mp4", "of somebody else");
  for (const Overwrite overwrite : {Overwrite::kRefuse, Overwrite::kAllow}) {
    EXPECT_THAT(ErrorOf({{"left", first}}, overwrite),
                HasSubstr("left.mp4: exists already and is not replaced"));
  }
  EXPECT_EQ(ReadTextFile(recording() / "videos" / "left.mp4"), "of somebody else");
  fs::remove(recording() / "videos" / "left.mp4");
  fs::rename(first, folder_.path() / "a.MJPG");
  ImportVideos({{"left", folder_.path() / "a.MJPG"}}, {}, recording(), Overwrite::kRefuse);
  EXPECT_THAT(ErrorOf({{"left", second}}), HasSubstr("left.MJPG: exists already; --force repl"));
  ImportVideos({{"left", second}}, {}, recording(), Overwrite::kAllow);
  EXPECT_FALSE(fs::exists(recording() / "videos" / "left.MJPG"));  // a camera has one video
  ImportVideos({{"left", second}}, {}, recording(), Overwrite::kAllow);
  EXPECT_EQ(InspectVideo(recording() / "videos" / "left.avi").frame_count, 4);
  // The same video again is no other one.
  ImportVideos({{"left", second}}, {}, recording(), Overwrite::kRefuse);
  // A video that is in its place already stays there.
  ImportVideos({{"left", recording() / "videos" / "left.avi"}}, {}, recording(), Overwrite::kAllow);
  EXPECT_EQ(InspectVideo(recording() / "videos" / "left.avi").frame_count, 4);
}

TEST_F(VideoImport, RefusesWrongVideos) {
  const fs::path file = WriteVideo("a.avi", 3);
  EXPECT_THAT(ErrorOf({{"left", folder_.path() / "gone.avi"}}),
              HasSubstr("gone.avi: no such file"));
  EXPECT_THAT(ErrorOf({{"left", folder_.Write("no.avi", "none")}}),
              HasSubstr("no.avi: cannot be read as a video"));
  EXPECT_THAT(ErrorOf({{"a/b", file}}), HasSubstr("'a/b' cannot name a camera"));
  EXPECT_THAT(ErrorOf({{"left", file}, {"left", file}}), HasSubstr("'left' has two videos"));
  EXPECT_THAT(ErrorOf({{"left", file}, {"right", WriteVideo("c.avi", 3, 30.0)}}),
              HasSubstr("c.avi: expected 25 Hz as in"));
  WriteCamerasOf({"left", "right"});
  EXPECT_THAT(ErrorOf({{"lefd", file}}),
              HasSubstr("'lefd' is no camera of cameras.yaml; did you mean 'left'?"));
  EXPECT_THAT(ErrorOf({{"left", WriteVideo("d.avi", 3, 25.0, 32)}}),
              HasSubstr("d.avi: expected 64 x 48 px as in cameras.yaml, found 32 x 48"));
  EXPECT_FALSE(fs::exists(recording() / "videos"));
}

TEST_F(VideoImport, WritesCamerasThatFitTheFolder) {
  folder_.Write("rec/masks/left/000003.png", "");
  folder_.Write("rec/markers.csv", "frame,id,u,v,x,y,z\n0,0,0,0,0,0,0\n");
  EXPECT_THAT(InputErrorOf([&] { WriteCamerasOf({"lfet"}); }),
              HasSubstr("'left' is no camera of cameras.yaml; did you mean 'lfet'?"));
  EXPECT_FALSE(fs::exists(recording() / "cameras.yaml"));
  WriteCamerasOf({"left"});
  EXPECT_THAT(InputErrorOf([&] { WriteCamerasOf({"left"}); }),
              HasSubstr("cameras.yaml: exists already; --force replaces it"));
  SceneStart start = LyingCloth();
  start.frame_rate = 30.0;
  start.frame_count = 10;
  const auto write_start = [&] {
    OutputFolder folder = OpenRecording(recording(), "import video", Overwrite::kRefuse);
    WriteStart(start, &folder);
  };
  write_start();
  const Recording read = ReadRecording(recording());
  EXPECT_EQ(read.markers.size(), 1u);  // what lay there before stays
  EXPECT_EQ(read.cameras.size(), 1u);
  EXPECT_THAT(InputErrorOf(write_start), HasSubstr("recording.yaml: exists already"));
}

}  // namespace
}  // namespace clothfit
