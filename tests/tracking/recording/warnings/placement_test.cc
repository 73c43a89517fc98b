// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/placement.h"

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kSheetWidth = 0.6, kSheetHeight = 0.4;  // m
const Eigen::Vector3d kOrigin(0.1, 0.2, 0.5);

std::vector<Eigen::Vector2d> GridOfPoints() {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) points.emplace_back(kSheetWidth * i / 3, kSheetHeight * j / 2);
  return points;
}

// A flat cloth along x and y, where its start says it is. No markers yet.
Recording FlatRecording() {
  Recording recording;
  recording.frame_rate = 30.0;
  recording.frame_count = 20;
  recording.cloth.size = {kSheetWidth, kSheetHeight};
  recording.cloth.initial = FlatPlacement{kOrigin, {1, 0, 0}, {0, 1, 0}};
  return recording;
}

// With its markers where `place` has (u, v), relative to the cloth's origin.
template <class Place>
Recording WithMarkers(Place place, int frame = 0) {
  Recording recording = FlatRecording();
  for (const Eigen::Vector2d& uv : GridOfPoints()) {
    const int id = static_cast<int>(recording.markers.size());
    const Eigen::Vector3d position = kOrigin + place(uv.x(), uv.y());
    recording.markers.push_back({frame, id, uv, position});
  }
  return recording;
}

using Point = Eigen::Vector3d;

std::vector<std::string> WarningsOf(const Recording& recording) {
  std::vector<std::string> warnings;
  WarnOfPlacement(recording, &warnings);
  return warnings;
}

TEST(PlacementWarning, IsNoneWhereTheStartFits) {
  EXPECT_THAT(WarningsOf(WithMarkers([](double u, double v) { return Point(u, v, 0.02); })),
              ElementsAre());
}

TEST(PlacementWarning, IsNoneForHalfOfThePoints) {
  Recording recording = WithMarkers([](double u, double v) { return Point(u, v, 0); });
  for (size_t i = 0; i < recording.markers.size() / 2; ++i)
    recording.markers[i].position.z() += 1.0;
  EXPECT_THAT(WarningsOf(recording), ElementsAre());
  recording.markers.back().position.z() += 1.0;
  EXPECT_THAT(WarningsOf(recording), ElementsAre(HasSubstr("7 of 12 markers begin farther than")));
}

TEST(PlacementWarning, SaysHowFar) {
  EXPECT_THAT(WarningsOf(WithMarkers([](double u, double v) { return Point(u, v, 0.3); })),
              ElementsAre(HasSubstr("12 of 12 markers begin farther than 0.036 m from where the "
                                    "cloth's start has them, by 0.300 m in the median")));
}

TEST(PlacementWarning, NamesTheSymmetryThatFits) {
  int checked = 0;
  const auto expect = [&](const char* remedy, Point (*place)(double u, double v)) {
    EXPECT_THAT(WarningsOf(WithMarkers(place)),
                ElementsAre(HasSubstr(std::string("; the start would fit them ") + remedy + ":")));
    ++checked;
  };
  expect("with u reversed", [](double u, double v) { return Point(kSheetWidth - u, v, 0); });
  expect("with v reversed", [](double u, double v) { return Point(u, kSheetHeight - v, 0); });
  expect("with u and v reversed",
         [](double u, double v) { return Point(kSheetWidth - u, kSheetHeight - v, 0); });
  expect("with u and v exchanged", [](double u, double v) { return Point(v, u, 0); });
  expect("with u and v exchanged, then u reversed",
         [](double u, double v) { return Point(kSheetHeight - v, u, 0); });
  expect("with u and v exchanged, then v reversed",
         [](double u, double v) { return Point(v, kSheetWidth - u, 0); });
  expect("with u and v exchanged, then both reversed",
         [](double u, double v) { return Point(kSheetHeight - v, kSheetWidth - u, 0); });
  expect("moved by (0.3, 0, -0.1) m", [](double u, double v) { return Point(u + 0.3, v, -0.1); });
  expect("with u reversed, moved by (0, 0, 0.3) m",
         [](double u, double v) { return Point(kSheetWidth - u, v, 0.3); });
  EXPECT_EQ(checked, 9);
}

TEST(PlacementWarning, NamesNothingThatDoesNotFit) {
  const std::vector<std::string> warnings =
      WarningsOf(WithMarkers([](double u, double v) { return Point(0.5 * u, 0.5 * v, 0); }));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("12 markers begin farther than")));
  EXPECT_THAT(warnings, ElementsAre(Not(HasSubstr("would fit"))));
}

TEST(PlacementWarning, LeavesOutWhatIsFirstSeenLater) {
  const auto elsewhere = [](double u, double v) { return Point(u, v, 0.3); };
  EXPECT_EQ(WarningsOf(WithMarkers(elsewhere, 2)).size(), 1u);
  EXPECT_THAT(WarningsOf(WithMarkers(elsewhere, 4)), ElementsAre());  // after 0.13 s
}

TEST(PlacementWarning, SeesTracksInTheirCameras) {
  Recording recording = FlatRecording();
  Camera camera;  // 2 m above the cloth, looks down
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 600.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.camera_from_world_rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  camera.camera_from_world_translation = {-0.4, 0.4, 2.5};
  recording.cameras = {camera};
  for (const Eigen::Vector2d& uv : GridOfPoints()) {
    const int id = static_cast<int>(recording.tracks.size());
    recording.tracks.push_back(
        {0, 0, id, uv, ProjectPoint(camera, Point(kOrigin + Point(uv.x(), uv.y(), 0)))});
  }
  EXPECT_THAT(WarningsOf(recording), ElementsAre());
  std::get<FlatPlacement>(recording.cloth.initial) = {
      kOrigin + Point(0, kSheetHeight, 0), {1, 0, 0}, {0, -1, 0}};
  EXPECT_THAT(WarningsOf(recording), ElementsAre(HasSubstr("fit them with v reversed")));
  std::get<FlatPlacement>(recording.cloth.initial).origin.z() = 10.0;  // behind the camera
  EXPECT_THAT(WarningsOf(recording), ElementsAre(HasSubstr("12 of 12 tracks")));
}

TEST(PlacementWarning, KnowsTheVerticesOfAMesh) {
  const TestFolder folder;
  Recording recording = WithMarkers([](double u, double v) { return Point(u, v, 0); });
  recording.cloth.initial = MeshPlacement{
      folder.Write("cloth.obj",
                   "v 0.1 0.2 0.5\nv 0.7 0.2 0.5\nv 0.7 0.6 0.5\nv 0.1 0.6 0.5\n"
                   "vt 0 0\nvt 0.6 0\nvt 0.6 0.4\nvt 0 0.4\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")};
  EXPECT_THAT(WarningsOf(recording), ElementsAre());
  for (Marker& marker : recording.markers) marker.position.x() += 0.25;
  EXPECT_THAT(WarningsOf(recording), ElementsAre(HasSubstr("fit them moved by (0.25, 0, 0) m:")));
}

TEST(PlacementWarning, NamesAHandleWhereTheClothIsRight) {
  Recording recording = WithMarkers([](double u, double v) { return Point(u, v, 0); });
  HandleDescription handle;
  handle.name = "left";
  handle.path = HandleDescription::Path(20, kOrigin);
  recording.handles = {handle};
  EXPECT_THAT(WarningsOf(recording), ElementsAre());
  recording.handles[0].uv = {kSheetWidth, 0.0};
  EXPECT_THAT(WarningsOf(recording),
              ElementsAre(HasSubstr("handle left: its path begins 0.600 m")));
  std::get<FlatPlacement>(recording.cloth.initial).origin.z() += 0.3;  // then the cloth is wrong
  EXPECT_THAT(WarningsOf(recording), ElementsAre(HasSubstr("12 of 12 markers")));
}

}  // namespace
}  // namespace clothfit
