// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cameras of COLMAP and OpenCV, and their change of world.
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "tests/support/test_folder.h"
#include "tracking/camera/world_change.h"
#include "tracking/import/cameras/colmap.h"
#include "tracking/import/cameras/opencv.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

// Half a turn about the axis (1, 1, 0): x and y change places, z turns round.
const char* const kHalfTurn = "0 0.70710678118 0.70710678118 0";

class ColmapModel : public testing::Test {
 protected:
  void WriteModel(const std::string& cameras, const std::string& images) const {
    folder_.Write("cameras.txt", "# Camera list\n# Number of cameras: 2\n" + cameras);
    folder_.Write("images.txt", "# Image list\n" + images);
  }

  Camera One(const std::string& cameras) const {
    WriteModel(cameras, "1 1 0 0 0 0 0 0 1 a.png\n\n");
    return ReadColmapCameras(folder_.path()).cameras.at(0);
  }

  std::string ErrorOf(const std::string& cameras, const std::string& images) const {
    WriteModel(cameras, images);
    return InputErrorOf([&] { ReadColmapCameras(folder_.path()); });
  }

  std::string ErrorOfCamera(const std::string& cameras) const {
    return ErrorOf(cameras, "1 1 0 0 0 0 0 0 1 a.png\n\n");
  }

  TestFolder folder_;
};

TEST_F(ColmapModel, HasPosesAndPixelsFromTheCornerOfTheImage) {
  WriteModel("7 PINHOLE 640 480 500 510 320 240\n",
             std::string("1 1 0 0 0 0.1 0.2 0.3 7 second.png\n"
                         "1.5 2.5 -1 3.5 4.5 12\n"
                         "2 ") +
                 kHalfTurn + " 1 2 3 7 a first.png\n\n");
  const ColmapCameras model = ReadColmapCameras(folder_.path());
  ASSERT_EQ(model.cameras.size(), 2u);
  const Camera& first = model.cameras[0];
  EXPECT_EQ(first.name, "a first");
  EXPECT_EQ(first.width, 640);
  EXPECT_EQ(first.height, 480);
  EXPECT_EQ(first.fx, 500.0);
  EXPECT_EQ(first.fy, 510.0);
  EXPECT_EQ(first.cx, 319.5);
  EXPECT_EQ(first.cy, 239.5);
  const Eigen::Vector3d turned = CameraFromWorld<double>(first, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_LT((turned - Eigen::Vector3d(1.2, 2.1, 2.7)).norm(), 1e-9);
  EXPECT_EQ(model.cameras[1].name, "second");
  EXPECT_EQ(model.cameras[1].camera_from_world_translation, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_TRUE(model.notes.empty());
}

TEST_F(ColmapModel, KnowsTheLensesThatOpencvKnows) {
  using Distortion = std::array<double, 5>;
  EXPECT_EQ(One("1 SIMPLE_PINHOLE 64 48 50 32 24\n").fy, 50.0);
  EXPECT_EQ(One("1 SIMPLE_RADIAL 64 48 50 32 24 0.1\n").distortion, (Distortion{0.1, 0, 0, 0, 0}));
  EXPECT_EQ(One("1 RADIAL 64 48 50 32 24 0.1 0.2\n").distortion, (Distortion{0.1, 0.2, 0, 0, 0}));
  EXPECT_EQ(One("1 OPENCV 64 48 50 51 32 24 0.1 0.2 0.3 0.4\n").distortion,
            (Distortion{0.1, 0.2, 0.3, 0.4, 0}));
  const Camera full = One("1 FULL_OPENCV 64 48 50 51 32 24 0.1 0.2 0.3 0.4 0.5 0 0 0\n");
  EXPECT_EQ(full.distortion, (Distortion{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(full.fy, 51.0);
  EXPECT_EQ(full.cy, 23.5);
  EXPECT_THAT(ErrorOfCamera("1 FULL_OPENCV 64 48 50 51 32 24 0 0 0 0 0 0 0.1 0\n"),
              HasSubstr("cameras.txt: line 3: PARAMS: expected k4 = k5 = k6 = 0, found 0.1"));
  EXPECT_THAT(ErrorOfCamera("1 OPENCV_FISHEYE 64 48 50 51 32 24 0 0 0 0\n"),
              HasSubstr("camera model 'OPENCV_FISHEYE': expected one of FULL_OPENCV, OPENCV"));
  EXPECT_THAT(ErrorOfCamera("1 RADIAL 64 48 50 32 24 0.1\n"),
              HasSubstr("PARAMS: expected 5 numbers for RADIAL, found 4"));
}

TEST_F(ColmapModel, TakesAFolderOfImagesForACamera) {
  WriteModel("1 PINHOLE 64 48 50 50 32 24\n2 PINHOLE 32 24 50 50 16 12\n",
             "1 1 0 0 0 0 0 1 2 right/000007.png\n\n"
             "2 1 0 0 0 0.5 0 0 1 left/000001.png\n\n"
             "3 1 0 0 0 0 0 0 1 left/000000.png\n\n");
  const ColmapCameras model = ReadColmapCameras(folder_.path());
  ASSERT_EQ(model.cameras.size(), 2u);
  EXPECT_EQ(model.cameras[0].name, "left");
  EXPECT_EQ(model.cameras[0].camera_from_world_translation, Eigen::Vector3d::Zero());
  EXPECT_EQ(model.cameras[1].name, "right");
  EXPECT_EQ(model.cameras[1].width, 32);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_THAT(model.notes[0], HasSubstr("left: the pose of left/000000.png"));
  EXPECT_THAT(model.notes[0], HasSubstr("0 degrees and 0.5 units"));
  EXPECT_EQ(ReadColmapCameras(folder_.path(), ColmapNaming::kStem).cameras.size(), 3u);
}

TEST_F(ColmapModel, RefusesWrongImages) {
  const std::string camera = "1 PINHOLE 64 48 50 50 32 24\n";
  EXPECT_THAT(ErrorOf(camera, "1 0 0 0 0 0 0 0 1 a.png\n\n"),
              HasSubstr("images.txt: line 2: QW QX QY QZ: expected a rotation, of length 1, found "
                        "length 0"));
  EXPECT_THAT(ErrorOf(camera, "1 1 0 0 0 0 0 0 2 a.png\n\n"), HasSubstr("CAMERA_ID 2 is not in"));
  EXPECT_THAT(ErrorOf(camera, "1 1 0 0 0 0 0\n"), HasSubstr("images.txt: line 2: TZ is missing"));
  EXPECT_THAT(ErrorOf(camera, "1 1 0 0 x 0 0 0 1 a.png\n"),
              HasSubstr("QZ: expected a finite number, found 'x'"));
  EXPECT_THAT(ErrorOf(camera, "1 1 0 0 0 0 0 0 1\n"), HasSubstr("NAME is missing"));
  EXPECT_THAT(ErrorOf(camera, ""), HasSubstr("images.txt: expected images, found none"));
  EXPECT_THAT(ErrorOf(camera + camera, ""), HasSubstr("CAMERA_ID 1 appears twice"));
  EXPECT_THAT(ErrorOf(camera, "1 1 0 0 0 0 0 0 1 a.png\n\n2 1 0 0 0 0 0 0 1 a.jpg\n\n"),
              HasSubstr("would both be camera 'a'"));
}

TEST_F(ColmapModel, HasToBeText) {
  EXPECT_THAT(InputErrorOf([&] { ReadColmapCameras(folder_.path() / "none"); }),
              HasSubstr("none: no such folder"));
  EXPECT_THAT(InputErrorOf([&] { ReadColmapCameras(folder_.path()); }),
              HasSubstr("cameras.txt: no such file"));
  folder_.Write("cameras.bin", "");
  EXPECT_THAT(InputErrorOf([&] { ReadColmapCameras(folder_.path()); }),
              HasSubstr("turn the binary model into text"));
}

class OpencvFile : public testing::Test {
 protected:
  fs::path WriteStorage(const std::string& name) const {
    fs::path file = folder_.path() / name;
    cv::FileStorage storage(file.string(), cv::FileStorage::WRITE);
    storage << "image_width" << 640 << "image_height" << 480;
    storage << "camera_matrix" << cv::Mat(cv::Matx33d(500, 0, 320, 0, 510, 240, 0, 0, 1));
    storage << "distortion_coefficients"
            << cv::Mat((cv::Mat_<float>(1, 4) << 0.5, -0.25, 0.125, 0.0625));
    storage << "rvec" << cv::Mat(cv::Vec3d(0.3, -0.2, 0.1));
    storage << "tvec" << cv::Mat(cv::Vec3d(10, 20, 3000));
    storage.release();
    return file;
  }

  std::string ErrorOf(const std::string& text, const OpencvOptions& options = {}) const {
    const fs::path file = folder_.Write("bad.yml", "%YAML:1.0\n---\n" + text);
    return InputErrorOf([&] { ReadOpencvCamera(file, options); });
  }

  TestFolder folder_;
};

TEST_F(OpencvFile, IsReadInEveryFormat) {
  cv::Matx33d rotation;
  cv::Rodrigues(cv::Vec3d(0.3, -0.2, 0.1), rotation);
  int checked = 0;
  for (const char* name : {"left.yml", "left.xml", "left.json"}) {
    const Camera camera = ReadOpencvCamera(WriteStorage(name));
    EXPECT_EQ(camera.name, "left");
    EXPECT_EQ(camera.width, 640);
    EXPECT_EQ(camera.height, 480);
    EXPECT_EQ(Eigen::Vector4d(camera.fx, camera.fy, camera.cx, camera.cy),
              Eigen::Vector4d(500, 510, 320, 240));
    EXPECT_EQ(camera.distortion, (std::array<double, 5>{0.5, -0.25, 0.125, 0.0625, 0.0}));
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR(camera.camera_from_world_rotation(row, column), rotation(row, column), 1e-12);
      }
    }
    EXPECT_EQ(camera.camera_from_world_translation, Eigen::Vector3d(10, 20, 3000));
    ++checked;
  }
  EXPECT_EQ(checked, 3);
}

const char* const kPlain =
    "K: [500, 0, 320, 0, 510, 240, 0, 0, 1]\n"
    "D: [0.1, 0.2, 0.3, 0.4, 0.5, 0, 0, 0]\n"
    "R: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]\n"
    "T: [1, 2, 3]\n";

TEST_F(OpencvFile, MayUseOtherNamesAndLists) {
  OpencvOptions options;
  options.image_size = Eigen::Vector2i(64, 48);
  options.camera_to_world = true;
  const fs::path file = folder_.Write("cam.yml", std::string("%YAML:1.0\n---\n") + kPlain);
  const Camera camera = ReadOpencvCamera(file, options);
  EXPECT_EQ(camera.width, 64);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_LT((CameraCentre(camera) - Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(camera.camera_from_world_rotation(0, 1), 1.0);
}

TEST_F(OpencvFile, RefusesWhatIsMissingOrWrong) {
  const std::string plain = kPlain;
  const auto without = [&](const std::string& from, const std::string& to) {
    std::string text = plain + "imageSize: [64, 48]\n";
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(ErrorOf(plain), HasSubstr("bad.yml: key 'image_width' is missing"));
  EXPECT_THAT(ErrorOf(without("K:", "k:")), HasSubstr("key 'camera_matrix' is missing; expected"));
  EXPECT_THAT(ErrorOf(without("R:", "r:")), HasSubstr("key 'R' is missing"));
  EXPECT_THAT(ErrorOf(without("T:", "x:")), HasSubstr("key 'T' is missing"));
  EXPECT_THAT(ErrorOf(without("0.5, 0, 0, 0", "0.5, 0, 1, 0")),
              HasSubstr("bad.yml: D: expected k1, k2, p1, p2, k3 and zeros beyond"));
  EXPECT_THAT(ErrorOf(without("[1, 0, 0]", "[2, 0, 0]")), HasSubstr("R: expected a rotation"));
  EXPECT_THAT(ErrorOf(without("[1, 2, 3]", "[1, 2]")), HasSubstr("T: expected 3 numbers"));
  EXPECT_THAT(ErrorOf(without("[64, 48]", "[64]")), HasSubstr("imageSize: expected width and"));
  EXPECT_THAT(ErrorOf(without("[64, 48]", "[64.5, 48]")), HasSubstr("imageSize: expected width"));
  EXPECT_THAT(ErrorOf(without("[1, 2, 3]", "far")), HasSubstr("T: expected a matrix or a list"));
  EXPECT_THAT(InputErrorOf([] { ReadOpencvCamera("gone.yml"); }), HasSubstr("gone.yml: no such"));
  EXPECT_THAT(
      InputErrorOf([&] { ReadOpencvCamera(folder_.Write("list.yml", "%YAML:1.0\n---\n- 1\n")); }),
      HasSubstr("list.yml: expected keys and values"));
  const fs::path file = folder_.Write("text.xml", "no calibration");
  EXPECT_THAT(InputErrorOf([&] { ReadOpencvCamera(file); }),
              HasSubstr("text.xml: expected keys and values"));
}

TEST(WorldChange, KeepsEveryPixelWhereItIs) {
  Camera camera;
  camera.fx = camera.fy = 100.0;
  camera.camera_from_world_rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  camera.camera_from_world_translation = {0.2, 0.1, 4.0};
  const Eigen::Vector3d point(0.3, -0.5, 0.7);
  int checked = 0;
  for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    WorldChange change = TurnUp(axis, 2.5);
    EXPECT_NEAR(change.world_from_calibration.determinant(), 1.0, 1e-12);
    change.translation = {1.0, 2.0, 3.0};
    const Eigen::Vector3d moved =
        change.scale * (change.world_from_calibration * point) + change.translation;
    const Camera in_world = InWorld(camera, change);
    EXPECT_LT((ProjectPoint(in_world, moved) - ProjectPoint(camera, point)).norm(), 1e-9);
    EXPECT_NEAR(CameraFromWorld<double>(in_world, moved).z(),
                2.5 * CameraFromWorld<double>(camera, point).z(), 1e-12);
    ++checked;
  }
  EXPECT_EQ(checked, 6);
  EXPECT_LT((TurnUp("-y", 1.0).world_from_calibration * Eigen::Vector3d(0, -1, 0) -
             Eigen::Vector3d::UnitZ())
                .norm(),
            1e-12);
}

TEST(WorldChange, IsReadFromSixteenNumbers) {
  const WorldChange change =
      ParseSimilarity("--transform", {0, -2, 0, 5, 2, 0, 0, 6, 0, 0, 2, 7, 0, 0, 0, 1});
  EXPECT_NEAR(change.scale, 2.0, 1e-12);
  EXPECT_NEAR(change.world_from_calibration(1, 0), 1.0, 1e-12);
  EXPECT_EQ(change.translation, Eigen::Vector3d(5, 6, 7));
  EXPECT_THAT(InputErrorOf([] {
                ParseSimilarity("--transform", {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
              }),
              HasSubstr("--transform: expected a rotation times a scale"));
  EXPECT_THAT(InputErrorOf([] {
                ParseSimilarity("--transform", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
              }),
              HasSubstr("found determinant -1"));
  EXPECT_THAT(InputErrorOf([] {
                ParseSimilarity("--transform", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1});
              }),
              HasSubstr("end in 0 0 0 1"));
  EXPECT_THAT(InputErrorOf([] { TurnUp("up", 1.0); }), HasSubstr("--up: expected x, y, z"));
  EXPECT_THAT(InputErrorOf([] { TurnUp("z", 0.0); }),
              HasSubstr("--scale: expected a number above"));
}

}  // namespace
}  // namespace clothfit
