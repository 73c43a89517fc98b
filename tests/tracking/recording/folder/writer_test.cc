// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"
#include "tracking/recording/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// A recording whose numbers have no short decimals.
Recording AwkwardRecording() {
  const TestFolder folder;
  WriteFiles(CompleteRecordingFiles(), folder);
  Recording recording = ReadRecording(folder.path());
  recording.files.clear();
  recording.name = "say \"hi\": # 1";
  recording.frame_rate = 30000.0 / 1001.0;
  recording.cloth.size = {std::sqrt(2.0), 1.0 / 0.7};
  recording.cloth.areal_density = 0.1 + 0.2;
  recording.gravity = {1e-17, -0.0, -9.80665};
  recording.markers[0].position = {1.0 / 3.0, -1e-300, 1e4 / 7.0};
  recording.tracks[0].pixel = {std::sqrt(200.0), std::nextafter(30.0, 31.0)};
  (*recording.handles[0].path)[5] = Eigen::Vector3d(0.1, 0.2, 0.7).normalized();
  recording.cameras[0].fx = 1e3 / 7.0;
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  recording.cameras[0].camera_from_world_rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  return recording;
}

Recording WriteAndRead(const Recording& recording) {
  const TestFolder folder;
  WriteRecording(recording, folder.path());
  return ReadRecording(folder.path());
}

void ExpectSameScene(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.frame_rate, b.frame_rate);
  EXPECT_EQ(a.frame_count, b.frame_count);
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.ground_height, b.ground_height);
  EXPECT_EQ(a.cloth.size, b.cloth.size);
  EXPECT_EQ(a.cloth.resolution, b.cloth.resolution);
  EXPECT_EQ(a.cloth.areal_density, b.cloth.areal_density);
  EXPECT_EQ(a.noise.marker, b.noise.marker);
  EXPECT_EQ(a.noise.layout, b.noise.layout);
  EXPECT_EQ(a.noise.track, b.noise.track);
  EXPECT_EQ(a.noise.silhouette, b.noise.silhouette);
  EXPECT_EQ(a.noise.obstacles, b.noise.obstacles);
  ASSERT_EQ(a.splits.held_out_frames.has_value(), b.splits.held_out_frames.has_value());
  if (a.splits.held_out_frames) {
    EXPECT_EQ(a.splits.held_out_frames->first, b.splits.held_out_frames->first);
    EXPECT_EQ(a.splits.held_out_frames->last, b.splits.held_out_frames->last);
  }
  EXPECT_EQ(a.splits.held_out_cameras, b.splits.held_out_cameras);
}

void ExpectSameHandlesAndCameras(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.handles.size(), b.handles.size());
  for (size_t i = 0; i < a.handles.size(); ++i) {
    EXPECT_EQ(a.handles[i].name, b.handles[i].name);
    EXPECT_EQ(a.handles[i].uv, b.handles[i].uv);
    EXPECT_EQ(a.handles[i].path, b.handles[i].path);
    EXPECT_EQ(a.handles[i].path_sigma, b.handles[i].path_sigma);
    EXPECT_EQ(a.handles[i].released_after, b.handles[i].released_after);
  }
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (size_t i = 0; i < a.cameras.size(); ++i) {
    const Camera& p = a.cameras[i];
    const Camera& q = b.cameras[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(std::make_pair(p.width, p.height), std::make_pair(q.width, q.height));
    EXPECT_EQ(Eigen::Vector4d(p.fx, p.fy, p.cx, p.cy), Eigen::Vector4d(q.fx, q.fy, q.cx, q.cy));
    EXPECT_EQ(p.distortion, q.distortion);
    EXPECT_EQ(p.camera_from_world_rotation, q.camera_from_world_rotation);
    EXPECT_EQ(p.camera_from_world_translation, q.camera_from_world_translation);
  }
}

void ExpectSameObservations(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.markers.size(), b.markers.size());
  for (size_t i = 0; i < a.markers.size(); ++i) {
    EXPECT_EQ(a.markers[i].frame, b.markers[i].frame);
    EXPECT_EQ(a.markers[i].id, b.markers[i].id);
    EXPECT_EQ(a.markers[i].uv, b.markers[i].uv);
    EXPECT_EQ(a.markers[i].position, b.markers[i].position);
  }
  ASSERT_EQ(a.tracks.size(), b.tracks.size());
  for (size_t i = 0; i < a.tracks.size(); ++i) {
    EXPECT_EQ(a.tracks[i].frame, b.tracks[i].frame);
    EXPECT_EQ(a.tracks[i].camera, b.tracks[i].camera);
    EXPECT_EQ(a.tracks[i].id, b.tracks[i].id);
    EXPECT_EQ(a.tracks[i].uv, b.tracks[i].uv);
    EXPECT_EQ(a.tracks[i].pixel, b.tracks[i].pixel);
  }
}

void ExpectSameShape(const ObstacleDescription& a, const ObstacleDescription& b) {
  ASSERT_EQ(a.shape.index(), b.shape.index());
  if (const auto* ball = std::get_if<BallShape>(&a.shape)) {
    EXPECT_EQ(ball->radius, std::get<BallShape>(b.shape).radius);
  } else if (const auto* bar = std::get_if<BarShape>(&a.shape)) {
    EXPECT_EQ(bar->radius, std::get<BarShape>(b.shape).radius);
    EXPECT_EQ(bar->length, std::get<BarShape>(b.shape).length);
  } else if (const auto* box = std::get_if<BoxShape>(&a.shape)) {
    EXPECT_EQ(box->size, std::get<BoxShape>(b.shape).size);
    EXPECT_EQ(box->below, std::get<BoxShape>(b.shape).below);
  } else {
    EXPECT_EQ(std::get<MeshShape>(a.shape).file.filename(),
              std::get<MeshShape>(b.shape).file.filename());
  }
}

TEST(WriteRecording, RoundTripsObstacles) {
  const TestFolder folder;
  Recording recording = AwkwardRecording();
  recording.obstacles.resize(4);
  recording.obstacles[0] = {"a ball", BallShape{1.0 / 3.0}, {{{0.1, 1e-17, 3.0}, {0, 0, 0}}}};
  recording.obstacles[1] = {"bar", BarShape{0.01, 2.0 / 7.0}, {{{1, 2, 3}, {0, 1.0 / 7.0, 1}}}};
  recording.obstacles[2] = {"box", BoxShape{{0.1, 0.2, 1.0 / 3.0}, 0.7}, {}};
  for (int frame = 0; frame < recording.frame_count; ++frame)
    recording.obstacles[2].path.push_back({{frame / 3.0, 0, 1}, {0, frame / 7.0, 0}});
  const auto mesh = folder.Write("bust.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  recording.obstacles[3] = {"bust", MeshShape{mesh}, {{{0, 0, 0}, {0, 0, 0}}}};
  recording.noise.obstacles = 1.0 / 70.0;
  recording.noise.layout = 1.0 / 300.0;
  const TestFolder written;
  WriteRecording(recording, written.path());
  const Recording again = ReadRecording(written.path());
  ASSERT_EQ(again.obstacles.size(), 4u);
  EXPECT_EQ(again.noise.obstacles, recording.noise.obstacles);
  EXPECT_EQ(again.noise.layout, recording.noise.layout);
  for (size_t i = 0; i < 4; ++i) {
    const ObstacleDescription &a = recording.obstacles[i], &b = again.obstacles[i];
    EXPECT_EQ(a.name, b.name);
    ExpectSameShape(a, b);
    ASSERT_EQ(a.path.size(), b.path.size());
    for (size_t k = 0; k < a.path.size(); ++k) {
      EXPECT_EQ(a.path[k].position, b.path[k].position);
      EXPECT_EQ(a.path[k].rotation, b.path[k].rotation);
    }
  }
}

TEST(WriteRecording, RoundTripsExactly) {
  const Recording recording = AwkwardRecording();
  ASSERT_EQ(recording.handles.size(), 2u);
  ASSERT_EQ(recording.markers.size(), 3u);
  ASSERT_EQ(recording.tracks.size(), 3u);
  const Recording again = WriteAndRead(recording);
  ExpectSameScene(recording, again);
  ExpectSameHandlesAndCameras(recording, again);
  ExpectSameObservations(recording, again);
  EXPECT_TRUE(std::signbit(again.gravity.y()));
}

TEST(WriteRecording, RoundTripsEveryInitialPlacement) {
  Recording recording = AwkwardRecording();
  recording.cloth.initial = FlatPlacement{{0.1, 1.0 / 3.0, 2}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(std::get<FlatPlacement>(WriteAndRead(recording).cloth.initial).origin,
            Eigen::Vector3d(0.1, 1.0 / 3.0, 2));

  PointPlacement points;
  points.points = {{{0, 0}, {0, 0, 1.0 / 3.0}}, {{1, 0}, {1, 0, 0}}, {{0, 1.0 / 7.0}, {0, 1, 0}}};
  recording.cloth.initial = points;
  const PointPlacement again = std::get<PointPlacement>(WriteAndRead(recording).cloth.initial);
  ASSERT_EQ(again.points.size(), 3u);
  EXPECT_EQ(again.points[2].uv, points.points[2].uv);
  EXPECT_EQ(again.points[0].position, points.points[0].position);

  const TestFolder elsewhere;
  recording.cloth.initial = MeshPlacement{elsewhere.Write("my cloth.obj", "v 1 2 3\n")};
  const TestFolder folder;
  WriteRecording(recording, folder.path());
  const Recording with_mesh = ReadRecording(folder.path());
  const auto mesh = std::get<MeshPlacement>(with_mesh.cloth.initial);
  EXPECT_EQ(mesh.file, folder.path() / "my cloth.obj");
  EXPECT_EQ(ReadTextFile(mesh.file), "v 1 2 3\n");
  EXPECT_NO_THROW(WriteRecording(with_mesh, folder.path(), Overwrite::kAllow));  // onto itself
}

TEST(WriteRecording, LeavesOutWhatIsNotKnown) {
  Recording recording;
  recording.name = "bare";
  recording.markers = {{0, 1, {0, 0}, {0, 0, 0}}};
  const TestFolder folder;
  WriteRecording(recording, folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cameras.yaml"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tracks.csv"));
  const Recording again = ReadRecording(folder.path());
  ExpectSameScene(recording, again);
  EXPECT_FALSE(again.cloth.areal_density);
}

TEST(WriteRecording, RefusesToOverwriteUnlessTold) {
  const Recording recording = AwkwardRecording();
  const TestFolder folder;
  WriteRecording(recording, folder.path());
  EXPECT_THAT(InputErrorOf([&] { WriteRecording(recording, folder.path()); }),
              HasSubstr("already holds a recording"));

  Recording other;
  other.name = "other";
  other.markers = {{0, 1, {0, 0}, {0, 0, 0}}};
  WriteRecording(other, folder.path(), Overwrite::kAllow);
  const Recording again = ReadRecording(folder.path());
  EXPECT_EQ(again.name, "other");
  EXPECT_TRUE(again.tracks.empty());  // nothing of the first recording is left
  EXPECT_TRUE(again.cameras.empty());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "handles" / "corner_a.csv"));
}

TEST(WriteRecording, RefusesWrongValuesAndFolders) {
  Recording recording = AwkwardRecording();
  const TestFolder folder;
  const auto file = folder.Write("file", "");
  EXPECT_THAT(InputErrorOf([&] { WriteRecording(recording, file / "below"); }),
              HasSubstr("cannot be made"));
  recording.frame_rate = 0.0;
  EXPECT_THAT(InputErrorOf([&] { WriteRecording(recording, folder.path()); }),
              HasSubstr("frame_rate: expected a number above 0"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "recording.yaml"));
}

}  // namespace
}  // namespace clothfit
