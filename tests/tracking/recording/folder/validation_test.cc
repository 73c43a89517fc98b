// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Each way in which a recording can be wrong, one test each: a complete recording is spoilt in one
// place and must be refused with a line that names it.
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"
#include "tracking/recording/recording.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

struct BadInput {
  const char* name;
  const char* file;      // of the recording
  const char* right;     // text in it that is replaced; empty: the file is removed or added
  const char* wrong;     // what it is replaced by; null: the file is removed
  const char* expected;  // part of the error
};

void PrintTo(const BadInput& input, std::ostream* stream) { *stream << input.name; }

class BadRecording : public testing::TestWithParam<BadInput> {};

TEST_P(BadRecording, IsRefusedWithOneClearLine) {
  const BadInput& input = GetParam();
  TestFiles files = CompleteRecordingFiles();
  const std::string right = input.right;
  if (input.wrong == nullptr) {
    ASSERT_EQ(files.erase(input.file), 1u);
  } else if (right.empty()) {
    files[input.file] = input.wrong;
  } else {
    const size_t place = files[input.file].find(right);
    ASSERT_NE(place, std::string::npos) << "the test spoils nothing";
    files[input.file].replace(place, right.size(), input.wrong);
  }
  const TestFolder folder;
  WriteFiles(files, folder);
  EXPECT_THAT(InputErrorOf([&] { ReadRecording(folder.path()); }), HasSubstr(input.expected));
}

std::string BadInputName(const testing::TestParamInfo<BadInput>& info) { return info.param.name; }

constexpr const char* kYaml = "recording.yaml";
constexpr const char* kCameras = "cameras.yaml";
constexpr const char* kMarkers = "markers.csv";
constexpr const char* kTracks = "tracks.csv";
constexpr const char* kPath = "handles/corner_a.csv";

INSTANTIATE_TEST_SUITE_P(
    Obstacles, BadRecording,
    testing::Values(
        BadInput{"NoShape", kYaml,
                 "handles:", "obstacles:\n  - {name: a, position: [0, 0, 0]}\nhandles:",
                 "obstacles[0]: expected one of 'sphere', 'capsule', 'box' and 'mesh'"},
        BadInput{"NegativeRadius", kYaml, "handles:",
                 "obstacles:\n  - {name: a, sphere: {radius: -1}, position: [0, 0, 0]}\nhandles:",
                 "obstacles[0].sphere.radius: expected a number above 0, found -1"},
        BadInput{"NoMeshFile", kYaml, "handles:",
                 "obstacles:\n  - {name: a, mesh: gone.obj, position: [0, 0, 0]}\nhandles:",
                 "obstacles[0].mesh: no such file"},
        BadInput{"TwoPlaces", kYaml, "handles:",
                 "obstacles:\n  - {name: a, sphere: {radius: 1}, position: [0, 0, 0], "
                 "path: markers.csv}\nhandles:",
                 "obstacles[0].path: expected either 'path' or"},
        BadInput{"OtherKey", kYaml, "handles:",
                 "obstacles:\n  - {name: a, ball: {radius: 1}, position: [0, 0, 0]}\nhandles:",
                 "obstacles[0].ball: unknown key"}),
    BadInputName);

INSTANTIATE_TEST_SUITE_P(
    Scene, BadRecording,
    testing::Values(
        BadInput{"NoDescription", kYaml, "", nullptr, "recording.yaml: no such file"},
        BadInput{"OtherFormat", kYaml, "recording/1", "recording/2",
                 "recording.yaml: format: expected 'cloth-recording/1', found 'cloth-recording/2'"},
        BadInput{"NoFormat", kYaml, "format: cloth-recording/1\n", "",
                 "recording.yaml: format: required key is missing"},
        BadInput{"UnknownKey", kYaml, "frame_rate", "framerate",
                 "recording.yaml: framerate: unknown key; did you mean 'frame_rate'?"},
        BadInput{"UnknownNestedKey", kYaml, "resolution", "resolutoin",
                 "recording.yaml: cloth.resolutoin: unknown key; did you mean 'resolution'?"},
        BadInput{"MissingKey", kYaml, "frame_count: 10\n", "",
                 "recording.yaml: frame_count: required key is missing"},
        BadInput{"MissingNestedKey", kYaml, "  size: [1.4, 1.2]\n", "",
                 "recording.yaml: cloth.size: required key is missing"},
        BadInput{"WrongType", kYaml, "frame_count: 10", "frame_count: ten",
                 "recording.yaml: frame_count: expected an integer, found 'ten'"},
        BadInput{"WrongListLength", kYaml, "gravity: [0, 0, -9.81]", "gravity: [0, -9.81]",
                 "recording.yaml: gravity: expected a list of 3 numbers, found a list of 2"},
        BadInput{"NotFinite", kYaml, "-9.81", "-.inf",
                 "recording.yaml: gravity[2]: expected a finite number, found '-.inf'"},
        BadInput{"ZeroFrameRate", kYaml, "frame_rate: 30.0", "frame_rate: 0",
                 "recording.yaml: frame_rate: expected a number above 0, found 0"},
        BadInput{"ZeroFrameCount", kYaml, "frame_count: 10", "frame_count: 0",
                 "recording.yaml: frame_count: expected 1.."},
        BadInput{"AbsurdFrameCount", kYaml, "frame_count: 10", "frame_count: 2000000000",
                 "recording.yaml: frame_count: expected 1.."},
        BadInput{"GroundKey", kYaml, "height", "hight",
                 "recording.yaml: ground.hight: unknown key; did you mean 'height'?"},
        BadInput{"ZeroNoise", kYaml, "marker: 0.003", "marker: 0",
                 "recording.yaml: noise.marker: expected a number above 0, found 0"},
        BadInput{"ZeroLayoutNoise", kYaml, "marker: 0.003", "layout: 0",
                 "recording.yaml: noise.layout: expected a number above 0, found 0"},
        BadInput{"NegativeTrackNoise", kYaml, "track: 0.6", "track: -1",
                 "recording.yaml: noise.track: expected a number above 0, found -1"},
        BadInput{"ZeroSilhouetteNoise", kYaml, "silhouette: 1.5", "silhouette: 0",
                 "recording.yaml: noise.silhouette: expected a number above 0, found 0"},
        BadInput{"ZeroObstacleNoise", kYaml, "silhouette: 1.5", "obstacles: 0",
                 "recording.yaml: noise.obstacles: expected a number above 0, found 0"},
        BadInput{"HeldOutFramesOutside", kYaml, "[8, 9]", "[8, 10]",
                 "recording.yaml: splits.held_out_frames: frame 10 is outside 0..9"},
        BadInput{"HeldOutFramesReversed", kYaml, "[8, 9]", "[9, 8]",
                 "recording.yaml: splits.held_out_frames: expected [first, last], found [9, 8]"},
        BadInput{"HeldOutCameraUnknown", kYaml, "[cam1]", "[can1]",
                 "recording.yaml: splits.held_out_cameras: 'can1' is no camera of cameras.yaml; "
                 "did you mean 'cam1'?"}),
    BadInputName);

INSTANTIATE_TEST_SUITE_P(
    Cloth, BadRecording,
    testing::Values(
        BadInput{"ZeroSize", kYaml, "size: [1.4, 1.2]", "size: [1.4, 0]",
                 "recording.yaml: cloth.size[1]: expected a number above 0, found 0"},
        BadInput{"LowResolution", kYaml, "[31, 27]", "[31, 1]",
                 "recording.yaml: cloth.resolution: expected 2 to 1000 particles each way, found "
                 "[31, 1]"},
        BadInput{"FractionalResolution", kYaml, "[31, 27]", "[31, 2.5]",
                 "recording.yaml: cloth.resolution[1]: expected an integer, found '2.5'"},
        BadInput{"ZeroDensity", kYaml, "areal_density: 0.18", "areal_density: 0",
                 "recording.yaml: cloth.areal_density: expected a number above 0, found 0"},
        BadInput{"LongAxis", kYaml, "u_axis: [1, 0, 0]", "u_axis: [1.01, 0, 0]",
                 "recording.yaml: cloth.initial.u_axis: expected unit length, found 1.01"},
        BadInput{"ObliqueAxes", kYaml, "v_axis: [0, 1, 0]", "v_axis: [0.6, 0.8, 0]",
                 "recording.yaml: cloth.initial.v_axis: expected a direction perpendicular"},
        BadInput{"MissingAxis", kYaml, "    v_axis: [0, 1, 0]\n", "",
                 "recording.yaml: cloth.initial.v_axis: required key is missing"},
        BadInput{"PointsBesideAxes", kYaml, "    origin: [0, 0, 0.002]\n",
                 "    points: markers.csv\n",
                 "recording.yaml: cloth.initial.points: expected 'points' alone"},
        BadInput{"MeshBesideInitial", kYaml, "  initial:", "  mesh: markers.csv\n  initial:",
                 "recording.yaml: cloth.mesh: expected either 'mesh' or 'initial', found both"}),
    BadInputName);

INSTANTIATE_TEST_SUITE_P(
    Handles, BadRecording,
    testing::Values(
        BadInput{"MissingPathFile", kPath, "", nullptr,
                 "recording.yaml: handles[0].path: no such file"},
        BadInput{"PathInTruth", kYaml, "path: handles/corner_a.csv", "path: handles/../truth/a.csv",
                 "recording.yaml: handles[0].path: 'handles/../truth/a.csv' must lie inside"},
        BadInput{"PathOutside", kYaml, "path: handles/corner_a.csv", "path: ../a.csv",
                 "recording.yaml: handles[0].path: '../a.csv' must lie inside the recording"},
        BadInput{"PathAbsolute", kYaml, "path: handles/corner_a.csv", "path: /etc/passwd",
                 "recording.yaml: handles[0].path: '/etc/passwd' must lie inside the recording"},
        BadInput{"OffTheCloth", kYaml, "uv: [1.4, 0]", "uv: [1.5, 0]",
                 "recording.yaml: handles[1].uv: u = 1.5 is outside the cloth, 0..1.4"},
        BadInput{"ReleasedOutside", kYaml, "released_after: 7", "released_after: 10",
                 "recording.yaml: handles[1].released_after: frame 10 is outside 0..9"},
        BadInput{"ZeroSigma", kYaml, "path_sigma: 0.004", "path_sigma: 0",
                 "recording.yaml: handles[0].path_sigma: expected a number above 0, found 0"},
        BadInput{"RepeatedName", kYaml, "corner_b", "corner_a",
                 "recording.yaml: handles[1].name: 'corner_a' appears twice"},
        BadInput{"NameOfNoFile", kYaml, "corner_b", "a/b",
                 "recording.yaml: handles[1].name: 'a/b' cannot name a file"},
        BadInput{"UnknownKey", kYaml, "released_after", "release_after",
                 "recording.yaml: handles[1].release_after: unknown key; did you mean "
                 "'released_after'?"},
        BadInput{"FrameOutside", kPath, "4,0,0,0.2", "10,0,0,0.2",
                 "corner_a.csv: line 5: frame: 10 is outside 0..9"},
        BadInput{"FrameTwice", kPath, "4,0,0,0.2", "1,0,0,0.2",
                 "corner_a.csv: line 5: frame: 1 appeared already on line 3"},
        BadInput{"PartlyEmpty", kPath, "4,0,0,0.2", "4,0,,0.2",
                 "corner_a.csv: line 5: y: is empty while its neighbours are not"},
        BadInput{"NoPosition", kPath, "", "frame,x,y,z\n",
                 "recording.yaml: handles[0].path: expected at least one position"}),
    BadInputName);

INSTANTIATE_TEST_SUITE_P(
    Cameras, BadRecording,
    testing::Values(
        BadInput{"NoFile", kCameras, "", nullptr,
                 "cameras.yaml: no such file; the recording needs it for images, background, "
                 "masks, tracks.csv"},
        BadInput{"UnknownKey", kCameras, "distortion", "distorsion",
                 "cameras.yaml: cameras[0].distorsion: unknown key; did you mean 'distortion'?"},
        BadInput{"MissingKey", kCameras, "    t: [0, 0, 4]\n", "",
                 "cameras.yaml: cameras[1].t: required key is missing"},
        BadInput{"SingularK", kCameras, "[60, 0, 31.5, 0, 61", "[60, 0, 31.5, 0, 0",
                 "cameras.yaml: cameras[0].K: fy: expected a number above 0, found 0"},
        BadInput{"Skew", kCameras, "[60, 0, 31.5, 0, 61", "[60, 1, 31.5, 0, 61",
                 "cameras.yaml: cameras[0].K: expected [fx, 0, cx, 0, fy, cy, 0, 0, 1], found [60, "
                 "1, 31.5,"},
        BadInput{"ShortDistortion", kCameras, "[0.1, -0.05, 0.001, -0.002, 0.01]", "[0.1, -0.05]",
                 "cameras.yaml: cameras[0].distortion: expected a list of 5 numbers, found a list "
                 "of 2"},
        BadInput{"NotOrthogonal", kCameras, "R: [1, 0, 0, 0, 0, -1", "R: [1, 0, 0.001, 0, 0, -1",
                 "cameras.yaml: cameras[0].R: expected a rotation, found R R^T off the identity by "
                 "0.001"},
        BadInput{"Reflection", kCameras, "R: [1, 0, 0, 0, 0, -1", "R: [-1, 0, 0, 0, 0, -1",
                 "cameras.yaml: cameras[0].R: expected a rotation, found a reflection"},
        BadInput{"ZeroSize", kCameras, "size: [64, 48]", "size: [64, 0]",
                 "cameras.yaml: cameras[0].size: expected 1 to 20000 px each way"},
        BadInput{"RepeatedName", kCameras, "name: cam1", "name: cam0",
                 "cameras.yaml: cameras[1].name: 'cam0' appears twice"},
        BadInput{"PicturesOfUnknown", "images/cam7/000000.png", "", "",
                 "images/cam7: 'cam7' is no camera of cameras.yaml; did you mean 'cam0'?"},
        BadInput{"FrameOutside", "images/cam0/000010.png", "", "",
                 "images/cam0/000010.png: frame 10 is outside 0..9"},
        BadInput{"MaskFrameOutside", "masks/cam0/000010.png", "", "",
                 "masks/cam0/000010.png: frame 10 is outside 0..9"},
        BadInput{"FrameName", "images/cam0/1.png", "", "",
                 "images/cam0/1.png: expected a name of six digits such as 000042.png"},
        BadInput{"FrameEnding", "images/cam0/000001.jpg", "", "",
                 "images/cam0/000001.jpg: expected a name of six digits such as 000042.png"},
        BadInput{"ImageWithoutCameraFolder", "images/000001.png", "", "",
                 "images/000001.png: '000001.png' is no camera of cameras.yaml"},
        BadInput{"BackgroundOfUnknown", "background/cam9.png", "", "",
                 "background/cam9.png: 'cam9' is no camera of cameras.yaml"},
        BadInput{"SecondBackground", "background/cam0.webp", "", "",
                 "background/cam0.webp: is the second for its camera"}),
    BadInputName);

INSTANTIATE_TEST_SUITE_P(
    Observations, BadRecording,
    testing::Values(
        BadInput{"MarkerNan", kMarkers, "0.501", "nan",
                 "markers.csv: line 2: x: expected a finite number, found 'nan'"},
        BadInput{"MarkerInfinite", kMarkers, "0.249", "inf",
                 "markers.csv: line 2: y: expected a finite number, found 'inf'"},
        BadInput{"MarkerNoNumber", kMarkers, "0.249", "0,249",
                 "markers.csv: line 2: expected 7 fields, found 8"},
        BadInput{"MarkerEmptyUv", kMarkers, "0,3,0.5,0.25,", "0,3,,0.25,",
                 "markers.csv: line 2: u: expected a finite number, found ''"},
        BadInput{"MarkerPartlyEmpty", kMarkers, "1,4,1.4,1.2,,,", "1,4,1.4,1.2,1,,",
                 "markers.csv: line 4: y: is empty while its neighbours are not"},
        BadInput{"MarkerColumn", kMarkers, "frame,id,u", "frame,idd,u",
                 "markers.csv: line 1: unknown column 'idd'; did you mean 'id'?"},
        BadInput{"MarkerMissingColumn", kMarkers, "", "frame,id,u,v,x,y\n",
                 "markers.csv: line 1: column 'z' is missing"},
        BadInput{"MarkerOffTheCloth", kMarkers, "2,4,1.4,1.2", "2,4,1.4,1.3",
                 "markers.csv: line 5: v = 1.3 is outside the cloth, 0..1.2"},
        BadInput{"MarkerBelowTheCloth", kMarkers, "2,4,1.4,1.2", "2,4,-0.001,1.2",
                 "markers.csv: line 5: u = -0.001 is outside the cloth, 0..1.4"},
        BadInput{"MarkerFrameOutside", kMarkers, "2,4,1.4,1.2", "10,4,1.4,1.2",
                 "markers.csv: line 5: frame 10 is outside 0..9"},
        BadInput{"MarkerFrameNegative", kMarkers, "2,4,1.4,1.2", "-1,4,1.4,1.2",
                 "markers.csv: line 5: frame -1 is outside 0..9"},
        BadInput{"MarkerTwice", kMarkers, "2,4,1.4,1.2", "1,3,1.4,1.2",
                 "markers.csv: line 5: frame 1, id 3 appeared already on line 3"},
        BadInput{"TrackUnknownCamera", kTracks, "0,cam1", "0,cma1",
                 "tracks.csv: line 3: camera: 'cma1' is no camera of cameras.yaml; did you mean "
                 "'cam1'?"},
        BadInput{"TrackNoCamera", kTracks, "0,cam1", "0,", "tracks.csv: line 3: camera: is empty"},
        BadInput{"TrackTwice", kTracks, "5,cam0,1", "0,cam0,1",
                 "tracks.csv: line 4: frame 0, camera cam0, id 1 appeared already on line 2"},
        BadInput{"TrackFrameOutside", kTracks, "5,cam0,1", "11,cam0,1",
                 "tracks.csv: line 4: frame 11 is outside 0..9"},
        BadInput{"TrackOffTheCloth", kTracks, "0.5,0.5,22", "0.5,1.5,22",
                 "tracks.csv: line 4: v = 1.5 is outside the cloth, 0..1.2"},
        BadInput{"TrackNoNumber", kTracks, "20.25", "left",
                 "tracks.csv: line 2: x: expected a finite number, found 'left'"}),
    BadInputName);

std::string ErrorOf(const TestFiles& files) {
  const TestFolder folder;
  WriteFiles(files, folder);
  return InputErrorOf([&] { ReadRecording(folder.path()); });
}

TEST(ReadRecordingErrors, NoFolder) {
  EXPECT_THAT(InputErrorOf([] { ReadRecording("/no/such/folder"); }),
              HasSubstr("/no/such/folder: no such folder"));
}

TEST(ReadRecordingErrors, NoObservation) {
  TestFiles files = CompleteRecordingFiles();
  for (const char* name : {"images/cam0/000000.png", "images/cam0/000009.png", "markers.csv",
                           "masks/cam1/000003.png", "tracks.csv"}) {
    ASSERT_EQ(files.erase(name), 1u);
  }
  EXPECT_THAT(ErrorOf(files), HasSubstr("there is no observation; expected images, videos"));
  files["videos/cam0.avi"] = "";
  const TestFolder folder;
  WriteFiles(files, folder);
  EXPECT_NO_THROW(ReadRecording(folder.path()));
}

// The complete recording with another initial placement.
TestFiles WithInitial(const std::string& line) {
  TestFiles files = CompleteRecordingFiles();
  std::string& yaml = files["recording.yaml"];
  const size_t from = yaml.find("  initial:");
  yaml.replace(from, yaml.find("handles:") - from, line);
  return files;
}

TEST(ReadRecordingErrors, MissingMesh) {
  EXPECT_THAT(ErrorOf(WithInitial("  mesh: cloth.obj\n")),
              HasSubstr("recording.yaml: cloth.mesh: no such file"));
}

// The complete recording with an initial placement through these points.
TestFiles WithInitialPoints(const std::string& rows) {
  TestFiles files = WithInitial("  initial: {points: initial.csv}\n");
  files["initial.csv"] = "u,v,x,y,z\n" + rows;
  return files;
}

TEST(InitialPointErrors, TooFew) {
  EXPECT_THAT(ErrorOf(WithInitialPoints("0,0,0,0,0\n1,0,1,0,0\n")),
              HasSubstr("recording.yaml: cloth.initial.points: expected 3..3000 points, found 2"));
}

TEST(InitialPointErrors, TooMany) {
  std::string rows;
  for (int i = 0; i < 3001; ++i) rows += std::to_string(i * 1e-4) + ",0,0,0,0\n";
  EXPECT_THAT(ErrorOf(WithInitialPoints(rows)),
              HasSubstr("initial.csv: line 3002: expected at most 3000 rows"));
}

TEST(InitialPointErrors, Collinear) {
  EXPECT_THAT(ErrorOf(WithInitialPoints("0,0,0,0,0\n0.5,0.5,1,0,0\n1,1,0,1,0\n1.1,1.1,1,1,1\n")),
              HasSubstr("cloth.initial.points: the points lie on one line in (u, v)"));
}

TEST(InitialPointErrors, Twice) {
  EXPECT_THAT(ErrorOf(WithInitialPoints("0,0,0,0,0\n1,0,1,0,0\n0,1,0,1,0\n1,0,1,0,1\n")),
              HasSubstr("cloth.initial.points: point 4: (u, v) = (1, 0) appears twice"));
}

TEST(InitialPointErrors, OffTheCloth) {
  EXPECT_THAT(ErrorOf(WithInitialPoints("0,0,0,0,0\n1,0,1,0,0\n0,2,0,1,0\n")),
              HasSubstr("cloth.initial.points: point 3: v = 2 is outside the cloth, 0..1.2"));
}

TEST(InitialPointErrors, MissingFile) {
  TestFiles files = WithInitialPoints("");
  files.erase("initial.csv");
  EXPECT_THAT(ErrorOf(files), HasSubstr("cloth.initial.points: no such file"));
}

TEST(CheckRecording, AllowsRoundingAtTheEdgeOfTheCloth) {
  const TestFolder folder;
  WriteFiles(CompleteRecordingFiles(), folder);
  Recording recording = ReadRecording(folder.path());
  recording.markers[0].uv = {1.4 + 0.9e-6, -0.9e-6};
  EXPECT_NO_THROW(CheckRecording(recording));
  recording.markers[0].uv = {1.4 + 1.1e-6, 0.0};
  EXPECT_THAT(InputErrorOf([&] { CheckRecording(recording); }), HasSubstr("line 2: u = "));
}

TEST(CheckRecording, FindsWhatCannotComeFromDisk) {
  const TestFolder folder;
  WriteFiles(CompleteRecordingFiles(), folder);
  const Recording good = ReadRecording(folder.path());
  EXPECT_NO_THROW(CheckRecording(good));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int checked = 0;
  const auto expect_error = [&](const char* expected,
                                const std::function<void(Recording*)>& spoil) {
    Recording bad = good;
    spoil(&bad);
    EXPECT_THAT(InputErrorOf([&] { CheckRecording(bad); }), HasSubstr(expected));
    ++checked;
  };
  expect_error("expected finite numbers", [&](Recording* r) { r->markers[0].position.x() = nan; });
  expect_error("is outside the cloth", [&](Recording* r) { r->markers[0].uv.x() = nan; });
  expect_error("expected finite x, y", [&](Recording* r) { r->tracks[0].pixel.x() = nan; });
  expect_error("there is no camera number 5", [](Recording* r) { r->tracks[0].camera = 5; });
  expect_error("handles[0].path: expected 10 frames, found 4",
               [](Recording* r) { r->handles[0].path->resize(4); });
  expect_error("handles[0].path: expected finite",
               [&](Recording* r) { (*r->handles[0].path)[0] = Eigen::Vector3d(0, nan, 0); });
  expect_error("frame_rate: expected a number above 0", [&](Recording* r) { r->frame_rate = nan; });
  expect_error("gravity: expected finite numbers", [&](Recording* r) { r->gravity.x() = nan; });
  expect_error("ground.height: expected finite numbers",
               [&](Recording* r) { r->ground_height = nan; });
  expect_error("cameras[0].R: expected a rotation",
               [&](Recording* r) { r->cameras[0].camera_from_world_rotation(0, 0) = nan; });
  expect_error("cameras[0].t: expected finite numbers",
               [&](Recording* r) { r->cameras[0].camera_from_world_translation.x() = nan; });
  expect_error("expected cx and cy of at most 1e+07 px in K, and at most",
               [&](Recording* r) { r->cameras[0].distortion[0] = nan; });
  expect_error("cameras[0]: expected cx and cy", [](Recording* r) { r->cameras[0].cx = 1e200; });
  expect_error("expected finite x, y of at most 1e+07 px, found -1e+200",
               [](Recording* r) { r->tracks[0].pixel.x() = -1e200; });
  expect_error("obstacles[0].rotation: expected radians, at most 1e+06, found 1e+200",
               [](Recording* r) {
                 ObstacleDescription ball{"ball", BallShape{0.1}, {{}}};
                 ball.path[0].rotation.x() = 1e200;
                 r->obstacles = {ball};
               });
  expect_error("pictures of 1 cameras, but cameras.yaml holds 2",
               [](Recording* r) { r->files.resize(1); });
  EXPECT_EQ(checked, 16);
}

}  // namespace
}  // namespace clothfit
