// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From pictures on disk to observations on disk.
#include "tracking/features/track_recording.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/flat_scene.h"
#include "tests/support/test_folder.h"
#include "tracking/features/tracking_folder.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 4;

FlatPlacement PlacementAt(int frame) {
  return FlatScene::Placement({0.01 * frame, 0.0, 0.01 * frame}, 0.02 * frame);
}

// Three cameras with pictures and backgrounds, written once for all tests of this file.
class TrackRecordingTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    const FlatScene scene;
    Recording recording;
    recording.name = "flat";
    recording.frame_count = kFrames;
    recording.cloth.size = scene.size();
    recording.cloth.resolution = {9, 7};
    recording.cloth.initial = PlacementAt(0);
    const Eigen::Vector3d middle(0.4, 0.3, 0.0);
    recording.cameras = {LookAt({0.2, -0.4, 1.2}, middle), LookAt({0.7, -0.3, 1.2}, middle),
                         LookAt({0.4, 0.6, 1.3}, middle)};
    for (std::size_t c = 0; c < recording.cameras.size(); ++c)
      recording.cameras[c].name = "cam" + std::to_string(c);
    WriteRecording(recording, folder_->path());
    fs::create_directories(folder_->path() / "background");
    for (const Camera& camera : recording.cameras) {
      fs::create_directories(folder_->path() / "images" / camera.name);
      for (int frame = 0; frame < kFrames; ++frame) {
        cv::imwrite(Image(camera.name, frame).string(),
                    scene.Render(camera, PlacementAt(frame),
                                 {1.0, 2.0, 0.6, static_cast<unsigned>(10 * frame) + 1}));
      }
      cv::imwrite((folder_->path() / "background" / (camera.name + ".png")).string(),
                  scene.RenderEmpty(camera, {1.0, 1.0, 1.0, 7}));
    }
  }
  static void TearDownTestSuite() { delete folder_; }

  static fs::path Image(const std::string& camera, int frame) {
    return folder_->path() / "images" / camera / fmt::format("{:06d}.png", frame);
  }
  static Recording Read() { return ReadRecording(folder_->path()); }
  static TrackingResult Find(const Recording& recording, const TrackingOptions& options = {}) {
    return TrackRecording(recording, options);
  }
  // A copy whose file is spoilt.
  static fs::path Copy(const TestFolder& to) {
    fs::copy(folder_->path(), to.path() / "copy", fs::copy_options::recursive);
    return to.path() / "copy";
  }

  static TestFolder* folder_;
};
TestFolder* TrackRecordingTest::folder_ = nullptr;

double Distance(const Marker& marker) {
  const FlatPlacement at = PlacementAt(marker.frame);
  return (marker.position - at.origin - marker.uv.x() * at.u_axis - marker.uv.y() * at.v_axis)
      .norm();
}

TEST_F(TrackRecordingTest, FindsTracksMarkersAndMasks) {
  const Recording recording = Read();
  const TrackingResult found = Find(recording);
  EXPECT_EQ(found.num_frames, kFrames);
  EXPECT_EQ(found.pictures.size(), 3U * kFrames);
  for (const TrackedPicture& p : found.pictures) EXPECT_GT(p.mask_quality, 0.9);
  ASSERT_GT(found.tracks.size(), 500U);
  std::vector<double> pixels;
  const FlatScene scene;
  for (const Track& t : found.tracks) {
    pixels.push_back(
        (scene.Project(recording.cameras[t.camera], PlacementAt(t.frame), t.uv) - t.pixel).norm());
  }
  std::sort(pixels.begin(), pixels.end());
  EXPECT_LT(pixels[pixels.size() / 2], 0.2);
  EXPECT_LT(pixels[pixels.size() * 95 / 100], 0.6);
  std::vector<double> metres;
  for (const Marker& m : found.markers) metres.push_back(Distance(m));
  std::sort(metres.begin(), metres.end());
  ASSERT_GT(metres.size(), 100U);
  EXPECT_LT(metres[metres.size() / 2], 0.003);        // a pixel is 4 mm
  EXPECT_LT(metres[metres.size() * 99 / 100], 0.03);  // no outliers
  EXPECT_EQ(found.markers.back().frame, kFrames - 1);
}

TEST_F(TrackRecordingTest, IsTheSameForAnyNumberOfThreads) {
  TrackingOptions one, three;
  one.num_threads = 1;
  three.num_threads = 3;
  const TrackingResult a = Find(Read(), one), b = Find(Read(), three);
  ASSERT_EQ(a.tracks.size(), b.tracks.size());
  for (std::size_t i = 0; i < a.tracks.size(); ++i) EXPECT_EQ(a.tracks[i].pixel, b.tracks[i].pixel);
  ASSERT_EQ(a.markers.size(), b.markers.size());
  for (std::size_t i = 0; i < a.markers.size(); ++i)
    EXPECT_EQ(a.markers[i].position, b.markers[i].position);
}

// What a camera that is held out saw must not reach the fit by way of the markers.
TEST_F(TrackRecordingTest, MakesNoMarkersWithCamerasThatAreHeldOut) {
  Recording recording = Read();
  recording.splits.held_out_cameras = {"cam1", "cam2"};
  EXPECT_TRUE(Find(recording).markers.empty());
}

TEST_F(TrackRecordingTest, UsesWhatThereIs) {
  const TestFolder other;
  const fs::path copy = Copy(other);
  fs::remove(copy / "images" / "cam0" / "000002.png");  // one frame of one camera
  fs::remove_all(copy / "images" / "cam1");             // a camera without images
  fs::remove(copy / "background" / "cam2.png");         // one that cannot have masks
  const Recording recording = ReadRecording(copy);
  const TrackingResult found = Find(recording);
  std::vector<std::vector<int>> counts(3, std::vector<int>(kFrames, 0));
  for (const Track& t : found.tracks) ++counts[t.camera][t.frame];
  EXPECT_EQ(counts[0][2], 0);
  EXPECT_GT(counts[0][3], 50);
  EXPECT_EQ(counts[1][0], 0);
  EXPECT_GT(counts[2][3], 50);
}

TEST_F(TrackRecordingTest, TellsWhichPictureCannotBeUsed) {
  const TestFolder other;
  const fs::path copy = Copy(other), image = copy / "images" / "cam1" / "000001.png";
  const auto problem = [&] {
    return InputErrorOf([&] { TrackRecording(ReadRecording(copy), {}); });
  };
  cv::imwrite(image.string(), cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_THAT(problem(), testing::AllOf(testing::HasSubstr("cam1/000001.png"),
                                        testing::HasSubstr("320 x 240")));
  fs::copy_file(Image("cam1", 1), image, fs::copy_options::overwrite_existing);
  fs::resize_file(image, fs::file_size(image) / 3);  // cut off
  EXPECT_THAT(problem(), testing::HasSubstr("cam1/000001.png"));
  fs::remove_all(copy / "images");
  Recording bare = Read();
  bare.files.clear();
  EXPECT_THAT(InputErrorOf([&] { Find(bare); }), testing::HasSubstr("neither images nor videos"));
}

TEST_F(TrackRecordingTest, WritesARecordingThatCanBeRead) {
  const TestFolder other;
  const fs::path out = other.path() / "out";
  const TrackingResult found = TrackIntoFolder(Read(), {}, out, Overwrite::kRefuse);
  const Recording read = ReadRecording(out);
  EXPECT_EQ(read.tracks.size(), found.tracks.size());
  EXPECT_EQ(read.markers.size(), found.markers.size());
  EXPECT_EQ(read.files.at(0).masks.size(), static_cast<std::size_t>(kFrames));
  EXPECT_TRUE(fs::exists(out / "filters.csv"));
  EXPECT_THAT(InputErrorOf([&] { TrackIntoFolder(Read(), {}, out, Overwrite::kRefuse); }),
              testing::HasSubstr("already holds a recording"));
  EXPECT_THAT(
      InputErrorOf([&] { TrackIntoFolder(Read(), {}, folder_->path(), Overwrite::kAllow); }),
      testing::HasSubstr("is the recording itself"));
}

TEST_F(TrackRecordingTest, TakesMasksAsTheyAre) {
  const TestFolder other;
  const fs::path copy = Copy(other);
  const Recording plain = Read();
  for (int frame = 0; frame < kFrames; ++frame) {
    // The right half of the cloth only.
    cv::Mat mask = FlatScene().Mask(plain.cameras[0], PlacementAt(frame));
    mask.colRange(0, 160).setTo(0);
    fs::create_directories(copy / "masks" / "cam0");
    cv::imwrite((copy / "masks" / "cam0" / fmt::format("{:06d}.png", frame)).string(), mask);
  }
  int seen = 0;
  for (const Track& t : Find(ReadRecording(copy)).tracks) {
    if (t.camera != 0) continue;
    EXPECT_GE(t.pixel.x(), 159.0);
    ++seen;
  }
  EXPECT_GT(seen, 50);
}

TEST_F(TrackRecordingTest, StopsWhenAsked) {
  std::atomic<bool> stop = false;
  TrackingCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.on_frame = [&](int done) { stop = done == 2; };
  const TestFolder other;
  const TrackingResult found =
      TrackIntoFolder(Read(), {}, other.path() / "out", Overwrite::kRefuse, callbacks);
  EXPECT_EQ(found.num_frames, 2);
  EXPECT_EQ(ReadRecording(other.path() / "out").tracks.size(), found.tracks.size());
}

}  // namespace
}  // namespace clothfit
