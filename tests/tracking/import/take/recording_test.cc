// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/recording.h"

#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/support/motive_file.h"
#include "tests/support/test_folder.h"
#include "tracking/import/take/file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Points = std::vector<Eigen::Vector2d>;
using testing::HasSubstr;

// 3 x 3 markers, 0.1 m and 0.08 m apart.
Points GridPoints() {
  Points uv;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) uv.emplace_back(0.1 * column, 0.08 * row);
  }
  return uv;
}

TakeOptions TwoHandles() {
  TakeOptions options;
  options.handles = {"left=m0", "m2"};
  return options;
}

std::string AllNotes(const ImportedTake& imported) {
  std::string text;
  for (const std::string& note : imported.notes) text += note + "\n";
  return text;
}

std::string ErrorOf(const MarkerTake& take, const TakeOptions& options) {
  return InputErrorOf([&] { MakeTakeRecording(take, options); });
}

TEST(MakeTakeRecording, MakesMarkersHandlesAndPlacement) {
  const MarkerTake take = BentSheetTake(GridPoints(), 1e-5);
  TakeOptions options = TwoHandles();
  options.margin = 0.01;
  options.held_out_share = 0.25;
  const ImportedTake imported = MakeTakeRecording(take, options);
  const TestFolder folder;
  Recording made = imported.recording;
  made.name = "sheet";
  WriteRecording(made, folder.path());
  const Recording recording = ReadRecording(folder.path());  // which checks it
  EXPECT_EQ(recording.frame_count, 60);
  EXPECT_EQ(recording.frame_rate, 120.0);
  EXPECT_NEAR(recording.cloth.size.x(), 0.22, 2e-4);  // ten times the noise, at either end
  EXPECT_NEAR(recording.cloth.size.y(), 0.18, 2e-4);
  EXPECT_EQ(recording.cloth.resolution, Eigen::Vector2i(21, 17));
  ASSERT_EQ(recording.handles.size(), 2u);
  EXPECT_EQ(recording.handles[0].name, "left");
  EXPECT_EQ(recording.handles[1].name, "m2");
  EXPECT_LT((recording.handles[0].uv - Eigen::Vector2d(0.01, 0.01)).norm(), 2e-4);
  EXPECT_LT((recording.handles[1].uv - Eigen::Vector2d(0.21, 0.01)).norm(), 2e-4);
  EXPECT_EQ((*recording.handles[0].path)[30], take.markers[0].positions[30]);
  EXPECT_EQ(recording.markers.size(), 7u * 60u);
  EXPECT_EQ(std::get<PointPlacement>(recording.cloth.initial).points.size(), 9u);
  ASSERT_TRUE(recording.splits.held_out_frames);
  EXPECT_EQ(recording.splits.held_out_frames->first, 45);
  EXPECT_EQ(recording.splits.held_out_frames->last, 59);
  EXPECT_THAT(AllNotes(imported), HasSubstr("3 x 3 markers sit on a grid"));
  EXPECT_THAT(AllNotes(imported), HasSubstr("layout: rms"));
}

TEST(MakeTakeRecording, EstimatesTheSigmaOfTheMarkers) {
  constexpr double kNoise = 3e-4;
  MarkerTake take = BentSheetTake(GridPoints(), kNoise);
  for (MarkerPath& marker : take.markers) {  // a path that bends by less than the noise
    for (size_t frame = 0; frame < marker.positions.size(); ++frame) {
      marker.positions[frame]->x() += 0.2 * std::sin(0.01 * double(frame));
    }
  }
  const Recording recording = MakeTakeRecording(take, TwoHandles()).recording;
  // About 1600 correlated differences: a tenth is more than three sigmas. The sheet's own motion,
  // which is fast, adds to it.
  const double jitter = *MarkerJitter(take.markers);
  EXPECT_GT(jitter, 0.9 * kNoise);
  EXPECT_LT(jitter, 1.5 * kNoise);
  // The layout, on a grid by now, is off by about what noise adds to largest distances.
  EXPECT_GT(*recording.noise.marker, jitter);
  EXPECT_LT(*recording.noise.marker, 4.0 * kNoise);
  EXPECT_EQ(recording.handles[0].path_sigma, recording.noise.marker);
  TakeOptions options = TwoHandles();
  options.marker_sigma = 0.002;
  EXPECT_EQ(*MakeTakeRecording(take, options).recording.noise.marker, 0.002);
}

TEST(MarkerJitter, IsThatOfNoiseAlone) {
  EXPECT_FALSE(MarkerJitter({{"m0", HandleDescription::Path(10)}}));
  HandleDescription::Path still(10, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(MarkerJitter({{"m0", still}}), 0.0);
}

TEST(MakeTakeRecording, BeginsWhereEveryMarkerIsSeen) {
  MarkerTake take = BentSheetTake(GridPoints());
  for (const size_t frame : {0u, 1u, 2u, 20u}) take.markers[4].positions[frame].reset();
  take.markers[0].positions[1].reset();
  const ImportedTake imported = MakeTakeRecording(take, TwoHandles());
  EXPECT_EQ(imported.recording.frame_count, 57);
  EXPECT_EQ((*imported.recording.handles[0].path)[0], take.markers[0].positions[3]);
  EXPECT_EQ(imported.recording.markers.size(), 7u * 57u - 1u);
  EXPECT_THAT(AllNotes(imported), HasSubstr("the first 3 frames are left out"));
  EXPECT_THAT(AllNotes(imported), HasSubstr("(m4 at the first)"));
  for (size_t frame = 0; frame < 60; ++frame) {
    take.markers[frame % 2 == 0 ? 1 : 3].positions[frame].reset();
  }
  EXPECT_THAT(ErrorOf(take, TwoHandles()),
              HasSubstr("expected a frame that has all 9 markers; the fullest, 3, lacks m3"));
}

TEST(MakeTakeRecording, LeavesOutWhatIsHardlySeen) {
  Points uv = GridPoints();
  uv.emplace_back(0.5, 0.5);
  MarkerTake take = BentSheetTake(uv);
  for (size_t frame = 0; frame < 60; ++frame) {
    if (frame % 10 != 0) take.markers[9].positions[frame].reset();
  }
  const ImportedTake imported = MakeTakeRecording(take, TwoHandles());
  EXPECT_EQ(imported.uv.size(), 9u);
  EXPECT_THAT(AllNotes(imported),
              HasSubstr("left out, seen in less than 20 % of the frames: m9 (10.0 %)"));
  TakeOptions options = TwoHandles();
  options.least_seen = 0.1;
  EXPECT_EQ(MakeTakeRecording(take, options).uv.size(), 10u);
  options.ignored = {"m9"};
  EXPECT_EQ(MakeTakeRecording(take, options).uv.size(), 9u);
}

TEST(MakeTakeRecording, KeepsOneFrameOfSoMany) {
  const MarkerTake take = BentSheetTake(GridPoints());
  TakeOptions options = TwoHandles();
  options.every = 4;
  const Recording recording = MakeTakeRecording(take, options).recording;
  EXPECT_EQ(recording.frame_count, 15);
  EXPECT_EQ(recording.frame_rate, 30.0);
  EXPECT_EQ((*recording.handles[0].path)[3], take.markers[0].positions[12]);
}

TEST(MakeTakeRecording, LeavesOutAMarkerThatDoesNotKeepItsPlace) {
  MarkerTake take = BentSheetTake(GridPoints(), 1e-4);
  for (size_t frame = 30; frame < 60; ++frame) {
    *take.markers[5].positions[frame] += 0.2 * Eigen::Vector3d(std::sin(frame), std::cos(frame), 0);
  }
  const ImportedTake imported = MakeTakeRecording(take, TwoHandles());
  EXPECT_EQ(imported.uv.size(), 8u);
  EXPECT_THAT(AllNotes(imported), HasSubstr("m5 is left out: it does not keep its place"));
  TakeOptions options = TwoHandles();
  options.handles = {"m5"};  // what the user names stays
  EXPECT_EQ(MakeTakeRecording(take, options).uv.size(), 9u);
}

TEST(MakeTakeRecording, TakesALayoutAsItIs) {
  const MarkerTake take = BentSheetTake(GridPoints());
  TakeOptions options = TwoHandles();
  options.layout_file = "layout.csv";
  options.layout = LayoutByName();
  for (size_t i = 0; i < 9; ++i) {
    (*options.layout)["m" + std::to_string(i)] = GridPoints()[i] + Eigen::Vector2d(0.02, 0.03);
  }
  options.size = Eigen::Vector2d(0.25, 0.25);
  const ImportedTake imported = MakeTakeRecording(take, options);
  EXPECT_EQ(imported.recording.handles[1].uv, Eigen::Vector2d(0.22, 0.03));
  EXPECT_EQ(imported.recording.cloth.size, Eigen::Vector2d(0.25, 0.25));
  options.layout->erase("m7");
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("layout.csv: marker 'm7' of take.csv is missing"));
  options.ignored = {"m7"};
  EXPECT_EQ(MakeTakeRecording(take, options).uv.size(), 8u);
}

TEST(MakeTakeRecording, RefusesWrongNamesAndNumbers) {
  const MarkerTake take = BentSheetTake(GridPoints());
  TakeOptions options;
  options.handles = {"left=n0"};
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--handle: 'n0' is no marker of take.csv; did"));
  options.handles = {"left=m0", "m0"};
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--handle: 'm0' is named twice"));
  options = TakeOptions();
  options.ignored = {"m77"};
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--ignore: 'm77' is no marker of take.csv"));
  options.ignored = {"m1", "m2", "m3", "m4", "m5", "m6"};
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("take.csv: expected at least 4 markers, found 3"));
  options = TakeOptions();
  options.handles = {"none"};
  options.size = Eigen::Vector2d(0.1, 0.5);
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--size: expected at least 0.2"));
  options.margin = 0.01;
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--margin: expected either this or --size"));
  options = TakeOptions();
  options.every = 0;
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--every: expected 1 or more, found 0"));
  options = TakeOptions();
  options.held_out_share = 1.0;
  EXPECT_THAT(ErrorOf(take, options), HasSubstr("--held-out: expected 0 to less than 1, found 1"));
}

TEST(ReadLayout, ReadsWhatWasWritten) {
  const TestFolder folder;
  const fs::path file =
      folder.Write("layout.csv", LayoutAsCsv({"a b", "c"}, {{0.1, 0.2}, {0.3, 0}}));
  const LayoutByName layout = ReadLayout(file);
  EXPECT_EQ(layout.at("a b"), Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(layout.at("c"), Eigen::Vector2d(0.3, 0.0));
  folder.Write("layout.csv", "name,u,v\na,0,0\na,1,1\n");
  EXPECT_THAT(InputErrorOf([&] { ReadLayout(file); }),
              HasSubstr("line 3: name: 'a' appears twice"));
}

// Recordings of real cloth, written as Motive would export them and imported again.
class RealTake : public testing::TestWithParam<const char*> {};

TEST_P(RealTake, IsLaidOutAsItWas) {
  const fs::path path =
      fs::path(CLOTHFIT_SOURCE_DIR).parent_path() / "shared" / "real" / "mocap" / GetParam();
  if (!fs::exists(path)) GTEST_SKIP() << "there is no " << path;
  const Recording recording = ReadRecording(path);
  const MarkerTake take = TakeOfRecording(recording);
  const TestFolder folder;
  TakeOptions options;
  options.handles = {recording.handles[0].name, recording.handles[1].name};
  std::vector<std::string> notes;
  const ImportedTake imported = MakeTakeRecording(
      ReadTake(folder.Write("take.csv", MotiveCsv(take, "Millimeters", 1e-3)), {}, &notes),
      options);
  std::cout << AllNotes(imported);
  Points known;  // by the names of the take
  for (const std::string& name : imported.marker_names) {
    for (const HandleDescription& handle : recording.handles) {
      if (handle.name == name) known.push_back(handle.uv);
    }
    for (const Marker& marker : recording.markers) {
      if (marker.frame == 0 && "m" + std::to_string(marker.id) == name) known.push_back(marker.uv);
    }
  }
  ASSERT_EQ(known.size(), imported.uv.size());
  // Both scatter by 1.3 to 2.6 mm about the measured distances, and were made in different ways.
  EXPECT_LT(LayoutDifference(imported.uv, known), 0.003);
  EXPECT_EQ(imported.recording.frame_count, recording.frame_count);
  EXPECT_EQ(imported.recording.markers.size(), recording.markers.size());
  EXPECT_LT(imported.recording.handles[0].uv.y(), 0.001);
  EXPECT_LT(*MarkerJitter(take.markers), 1.5e-4);  // jitter of 0.01 to 0.12 mm is known
}

INSTANTIATE_TEST_SUITE_P(Real, RealTake, testing::Values("zig_zag", "take_072505"),
                         [](const testing::TestParamInfo<const char*>& take) {
                           return std::string(take.param);
                         });

}  // namespace
}  // namespace clothfit
