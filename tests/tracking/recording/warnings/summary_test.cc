// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/summary.h"

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Recording CompleteRecording() {
  const TestFolder folder;
  WriteFiles(CompleteRecordingFiles(), folder);
  return ReadRecording(folder.path());
}

// Nothing about it is worth a warning.
Recording FlawlessRecording() {
  Recording recording;
  recording.name = "flawless";
  recording.frame_count = 3;
  recording.cloth.areal_density = 0.2;
  recording.noise.marker = 0.001;
  HandleDescription handle;
  handle.name = "corner";
  handle.path = HandleDescription::Path(3, Eigen::Vector3d(0, 0, 0));
  handle.path_sigma = 0.001;
  recording.handles = {handle};
  for (int frame = 0; frame < 3; ++frame) {
    for (int id = 0; id < 3; ++id) {
      const Eigen::Vector2d uv(0.3 * id, 0.2 * id);
      recording.markers.push_back({frame, id, uv, {uv.x(), uv.y(), 0.01 * frame}});
    }
  }
  return recording;
}

TEST(DescribeRecording, NamesEverything) {
  const std::string text = DescribeRecording(CompleteRecording());
  int checked = 0;
  for (const char* part :
       {"two-corner-lift", "10 at 30 Hz, 0.33 s", "(0, 0, -9.81) m/s^2", "z = 0 m",
        "1.4 x 1.2 m, 31 x 27 particles, 0.18 kg/m^2; initially flat",
        "corner_a at (u, v) = (0, 0), path known in 3 of 10 frames (0..4) to 0.004 m",
        "to 0.004 m, never released",
        "corner_b at (u, v) = (1.4, 0), path unknown, released after frame 7",
        "3 positions of 2 points in 3 of 10 frames (0..2)",
        "3 positions of 2 features of 2 cameras in 2 of 10 frames (0..5)",
        "cam0, 64 x 48 px, with distortion, images in 2 of 10 frames (0..9), background\n",
        "cam1, 64 x 48 px, no distortion, masks in 1 of 10 frames (3..3), held out\n",
        "marker 0.003 m, track 0.6 px, silhouette 1.5 px", "frames 8..9, cameras cam1"}) {
    EXPECT_THAT(text, HasSubstr(part));
    ++checked;
  }
  EXPECT_EQ(checked, 14);
}

TEST(DescribeRecording, SaysWhatIsNotThere) {
  const std::string text = DescribeRecording(FlawlessRecording());
  EXPECT_THAT(text, HasSubstr("tracks      none"));
  EXPECT_THAT(text, HasSubstr("ground      none"));
  EXPECT_THAT(text, HasSubstr("track 0.5 px (assumed)"));
  EXPECT_THAT(text, HasSubstr("held out    nothing"));
}

TEST(Warnings, AreNoneForAFlawlessRecording) {
  EXPECT_THAT(Warnings(FlawlessRecording()), ElementsAre());
}

struct Oddity {
  const char* name;
  void (*spoil)(Recording*);
  const char* expected;
};

void PrintTo(const Oddity& oddity, std::ostream* stream) { *stream << oddity.name; }

void AddCamera(Recording* recording) {
  Camera camera;
  camera.name = "cam0";
  camera.width = camera.height = 100;
  recording->cameras.push_back(camera);
  recording->files.emplace_back();
}

class OddRecording : public testing::TestWithParam<Oddity> {};

TEST_P(OddRecording, IsWarnedOf) {
  Recording recording = FlawlessRecording();
  GetParam().spoil(&recording);
  ASSERT_NO_THROW(CheckRecording(recording));
  EXPECT_THAT(Warnings(recording), Contains(HasSubstr(GetParam().expected)));
}

std::string OddityName(const testing::TestParamInfo<Oddity>& oddity) { return oddity.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Warnings, OddRecording,
    testing::Values(
        Oddity{"Stretch", [](Recording* r) { r->markers[8].position.z() += 0.6; },
               "points are more than 10 % farther apart than on the cloth in 1 frames (worst: "
               "marker 1 and marker 2 at frame 2"},
        Oddity{"Jump", [](Recording* r) { r->markers[8].position.z() += 0.6; },
               "markers jump 1 times between frames (first: marker 2 by 0.610 m to frame 2)"},
        Oddity{"MovingUv", [](Recording* r) { r->markers[8].uv.x() += 0.01; },
               "1 markers change their (u, v) between frames (first: marker 2)"},
        Oddity{
            "FarFromInitial",
            [](Recording* r) { std::get<FlatPlacement>(r->cloth.initial).origin.z() = 0.1; },
            "handle corner: its path begins 0.100 m from where the cloth's start has its (u, v)"},
        Oddity{"StretchedInitial",
               [](Recording* r) {
                 r->cloth.initial = PointPlacement{
                     {{{0, 0}, {0, 0, 0}}, {{1, 0}, {1.2, 0, 0}}, {{0, 1}, {0, 1, 0}}}};
               },
               "the initial points are up to 20 % farther apart than on the cloth: (u, v) = (0, 0) "
               "and (1, 0)"},
        Oddity{"NothingMovesIt",
               [](Recording* r) {
                 r->handles.clear();
                 r->obstacles.clear();
                 r->ground_height = -1.0;
               },
               "there is no handle, and no obstacle under the cloth"},
        Oddity{"BelowGround", [](Recording* r) { r->ground_height = 0.05; },
               "the initial placement reaches 0.0500 m below the ground"},
        Oddity{"GapInPath", [](Recording* r) { (*r->handles[0].path)[1] = std::nullopt; },
               "handle corner: path lacks 1 of 3 frames (first: 1)"},
        Oddity{"NoPathSigma", [](Recording* r) { r->handles[0].path_sigma = std::nullopt; },
               "handle corner: no path_sigma given; 0.005 m is assumed"},
        Oddity{"SigmaWithoutPath", [](Recording* r) { r->handles[0].path = std::nullopt; },
               "handle corner: path_sigma without a path"},
        Oddity{"FreeFall", [](Recording* r) { r->handles.clear(); },
               "there is neither a handle nor ground"},
        Oddity{"NoNoise", [](Recording* r) { r->noise.marker = std::nullopt; },
               "no noise.marker given; 0.002 m is assumed"},
        Oddity{"NoDensity", [](Recording* r) { r->cloth.areal_density = std::nullopt; },
               "areal density is not known"},
        Oddity{"Gravity",
               [](Recording* r) {
                 r->gravity = {0, 0, -1.62};
               },
               "gravity is 1.62 m/s^2, not that of the Earth"},
        Oddity{"EmptyFrames", [](Recording* r) { r->markers.resize(3); },
               "2 frames are without any observation (first: 1)"},
        Oddity{"AllHeldOut",
               [](Recording* r) {
                 r->splits.held_out_frames = Splits::FrameRange{0, 2};
               },
               "everything observed is held out"},
        Oddity{"NoSilhouettes",
               [](Recording* r) {
                 AddCamera(r);
                 r->files[0].images[0] = "a.png";
               },
               "camera cam0: images but neither masks nor background"},
        Oddity{"ImagesAndVideo",
               [](Recording* r) {
                 AddCamera(r);
                 r->files[0].images[0] = "a.png";
                 r->files[0].video = "a.mp4";
               },
               "camera cam0: has images, so its video is not used"},
        Oddity{"TrackOutside",
               [](Recording* r) {
                 AddCamera(r);
                 r->tracks.push_back({0, 0, 1, {0, 0}, {100, 5}});
               },
               "1 rows of tracks.csv lie outside the picture"},
        Oddity{"OneCamera",
               [](Recording* r) {
                 AddCamera(r);
                 r->markers.clear();
                 r->tracks.push_back({0, 0, 1, {0, 0}, {50, 5}});
               },
               "a single camera: depth is only weakly known"}),
    OddityName);

TEST(Warnings, IgnoreAPathAfterTheRelease) {
  Recording recording = FlawlessRecording();
  (*recording.handles[0].path)[2] = std::nullopt;
  recording.handles[0].released_after = 1;
  EXPECT_THAT(Warnings(recording), Not(Contains(HasSubstr("path lacks"))));
}

}  // namespace
}  // namespace clothfit
