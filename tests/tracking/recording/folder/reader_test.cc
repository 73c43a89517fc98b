// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/test_folder.h"
#include "tracking/recording/recording.h"

namespace clothfit {
namespace {

Recording ReadFiles(const TestFiles& files) {
  const TestFolder folder;
  WriteFiles(files, folder);
  return ReadRecording(folder.path());
}

TEST(ReadRecording, ReadsTheScene) {
  const Recording recording = ReadFiles(CompleteRecordingFiles());
  EXPECT_EQ(recording.name, "two-corner-lift");
  EXPECT_EQ(recording.frame_rate, 30.0);
  EXPECT_EQ(recording.frame_count, 10);
  EXPECT_EQ(recording.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(recording.ground_height, 0.0);
  EXPECT_EQ(recording.noise.marker, 0.003);
  EXPECT_EQ(recording.noise.track, 0.6);
  EXPECT_EQ(recording.noise.silhouette, 1.5);
}

TEST(ReadRecording, ReadsTheCloth) {
  const ClothDescription cloth = ReadFiles(CompleteRecordingFiles()).cloth;
  EXPECT_EQ(cloth.size, Eigen::Vector2d(1.4, 1.2));
  EXPECT_EQ(cloth.resolution, Eigen::Vector2i(31, 27));
  EXPECT_EQ(cloth.areal_density, 0.18);
  ASSERT_TRUE(std::holds_alternative<FlatPlacement>(cloth.initial));
  EXPECT_EQ(std::get<FlatPlacement>(cloth.initial).origin, Eigen::Vector3d(0, 0, 0.002));
}

TEST(ReadRecording, ReadsHandlesWithGapsInTheirPaths) {
  const Recording recording = ReadFiles(CompleteRecordingFiles());
  ASSERT_EQ(recording.handles.size(), 2u);
  const HandleDescription& known = recording.handles[0];
  EXPECT_EQ(known.path_sigma, 0.004);
  EXPECT_FALSE(known.released_after);
  ASSERT_TRUE(known.path);
  ASSERT_EQ(known.path->size(), 10u);
  EXPECT_EQ((*known.path)[4], Eigen::Vector3d(0, 0, 0.2));
  EXPECT_FALSE((*known.path)[2]);  // empty fields
  EXPECT_FALSE((*known.path)[3]);  // no row
  const HandleDescription& unknown = recording.handles[1];
  EXPECT_FALSE(unknown.path);
  EXPECT_EQ(unknown.uv, Eigen::Vector2d(1.4, 0));
  EXPECT_EQ(unknown.released_after, 7);
}

TEST(ReadRecording, ReadsCameras) {
  const Recording recording = ReadFiles(CompleteRecordingFiles());
  ASSERT_EQ(recording.cameras.size(), 2u);
  const Camera& camera = recording.cameras[0];
  EXPECT_EQ(camera.name, "cam0");
  EXPECT_EQ(camera.width, 64);
  EXPECT_EQ(camera.height, 48);
  EXPECT_EQ(camera.fx, 60.0);
  EXPECT_EQ(camera.fy, 61.0);
  EXPECT_EQ(camera.cx, 31.5);
  EXPECT_EQ(camera.cy, 23.5);
  EXPECT_EQ(camera.distortion[3], -0.002);
  EXPECT_EQ(camera.camera_from_world_rotation(1, 2), -1.0);  // row-major on disk
  EXPECT_EQ(camera.camera_from_world_rotation(2, 1), 1.0);
  EXPECT_EQ(camera.camera_from_world_translation, Eigen::Vector3d(-0.7, 0.6, 3));
  EXPECT_EQ(recording.cameras[1].distortion, (std::array<double, 5>{}));
  EXPECT_EQ(FindCamera(recording, "cam1"), 1);
  EXPECT_FALSE(FindCamera(recording, "cam2"));
}

TEST(ReadRecording, ReadsMarkersAndTracks) {
  const Recording recording = ReadFiles(CompleteRecordingFiles());
  ASSERT_EQ(recording.markers.size(), 3u);  // one row has no position
  EXPECT_EQ(recording.markers[2].frame, 2);
  EXPECT_EQ(recording.markers[2].id, 4);
  EXPECT_EQ(recording.markers[2].uv, Eigen::Vector2d(1.4, 1.2));
  EXPECT_EQ(recording.markers[2].position, Eigen::Vector3d(1.39, 1.2, 0.2));
  ASSERT_EQ(recording.tracks.size(), 3u);
  EXPECT_EQ(recording.tracks[1].camera, 1);
  EXPECT_EQ(recording.tracks[0].pixel, Eigen::Vector2d(20.25, 30.5));
}

TEST(ReadRecording, ListsPicturesWithoutOpeningThem) {
  TestFiles files = CompleteRecordingFiles();
  files["videos/cam1.mp4"] = "no video at all";
  files["images/cam0/.thumbnails"] = "";
  const Recording recording = ReadFiles(files);
  ASSERT_EQ(recording.files.size(), 2u);
  ASSERT_EQ(recording.files[0].images.size(), 2u);
  EXPECT_EQ(recording.files[0].images.at(9).filename(), "000009.png");
  EXPECT_TRUE(recording.files[0].background);
  EXPECT_TRUE(recording.files[0].masks.empty());
  EXPECT_EQ(recording.files[1].masks.count(3), 1u);
  EXPECT_EQ(recording.files[1].video->filename(), "cam1.mp4");
}

TEST(ReadRecording, KnowsWhatIsHeldOut) {
  const Recording recording = ReadFiles(CompleteRecordingFiles());
  EXPECT_FALSE(IsHeldOutFrame(recording, 7));
  EXPECT_TRUE(IsHeldOutFrame(recording, 8));
  EXPECT_TRUE(IsHeldOutFrame(recording, 9));
  EXPECT_FALSE(IsHeldOutCamera(recording, 0));
  EXPECT_TRUE(IsHeldOutCamera(recording, 1));
}

TEST(ReadRecording, LeavesOptionalThingsEmpty) {
  TestFiles files;
  files["markers.csv"] = CompleteRecordingFiles().at("markers.csv");
  files["recording.yaml"] = R"(format: cloth-recording/1
name: least
frame_rate: 120
frame_count: 3
gravity: [0, 0, -9.81]
cloth:
  size: [1.4, 1.2]
  resolution: [5, 5]
  initial: {points: initial.csv}
)";
  files["initial.csv"] = "u,v,x,y,z\n0,0,0,0,1\n1,0,1,0,1\n0,1,0,0,0\n";
  const Recording recording = ReadFiles(files);
  EXPECT_FALSE(recording.ground_height);
  EXPECT_FALSE(recording.cloth.areal_density);
  EXPECT_FALSE(recording.noise.marker);
  EXPECT_FALSE(recording.splits.held_out_frames);
  EXPECT_TRUE(recording.handles.empty());
  EXPECT_TRUE(recording.cameras.empty());
  EXPECT_FALSE(IsHeldOutFrame(recording, 0));
  const auto& points = std::get<PointPlacement>(recording.cloth.initial).points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[2].position, Eigen::Vector3d(0, 0, 0));
}

TEST(ReadRecording, TakesAMeshInPlaceOfAnInitialPlacement) {
  TestFiles files = CompleteRecordingFiles();
  std::string& yaml = files["recording.yaml"];
  const size_t from = yaml.find("  initial:");
  yaml.replace(from, yaml.find("handles:") - from, "  mesh: cloth.obj\n");
  files["cloth.obj"] = "v 0 0 0\n";
  const Recording recording = ReadFiles(files);
  ASSERT_TRUE(std::holds_alternative<MeshPlacement>(recording.cloth.initial));
  EXPECT_EQ(std::get<MeshPlacement>(recording.cloth.initial).file, recording.path / "cloth.obj");
}

TEST(ReadRecording, NeverLooksIntoTruth) {
  TestFiles files = CompleteRecordingFiles();
  files["truth/points.csv"] = "neither,readable\n";
  files["truth/parameters.yaml"] = "[";
  EXPECT_EQ(ReadFiles(files).name, "two-corner-lift");
}

}  // namespace
}  // namespace clothfit
