// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/silhouette.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/flat_scene.h"
#include "tests/support/test_folder.h"
#include "tracking/recording/warnings/placement.h"

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const FlatPlacement kStart = FlatScene::Placement({0.0, 0.0, 0.0});
const FlatPlacement kHalfBeside = FlatScene::Placement({0.4, 0.0, 0.0});  // half of its width
const FlatPlacement kBeside = FlatScene::Placement({0.9, 0.0, 0.0});      // has none in common

// A cloth that starts at kStart, and cameras about it that saw nothing yet.
struct FilmedCloth {
  explicit FilmedCloth(int cameras) {
    recording.frame_rate = 30.0;
    recording.frame_count = 20;
    recording.cloth.size = scene.size();
    recording.cloth.initial = kStart;
    for (const Eigen::Vector3d& centre :
         {Eigen::Vector3d(0.4, -0.6, 1.2), {-0.5, 0.3, 1.2}, {0.4, 1.2, 1.2}})
      recording.cameras.push_back(LookAt(centre, {0.4, 0.3, 0.0}));
    recording.cameras[1].distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
    recording.cameras.resize(static_cast<size_t>(cameras));
    recording.files.resize(recording.cameras.size());
    for (size_t i = 0; i < recording.cameras.size(); ++i)
      recording.cameras[i].name = "cam" + std::to_string(i);
  }

  std::string Write(const std::string& name, const cv::Mat& picture) const {
    std::string file = (folder.path() / name).string();
    EXPECT_TRUE(cv::imwrite(file, picture));
    return file;
  }
  void AddMask(size_t camera, const FlatPlacement& cloth, int frame = 0) {
    recording.files[camera].masks[frame] =
        Write(MaskName(camera, frame), scene.Mask(recording.cameras[camera], cloth));
  }
  static std::string MaskName(size_t camera, int frame) {
    return "mask" + std::to_string(camera) + "-" + std::to_string(frame) + ".png";
  }

  std::vector<std::string> Warnings() const {
    std::vector<std::string> warnings;
    WarnOfSilhouettes(recording, &warnings);
    return warnings;
  }

  TestFolder folder;
  FlatScene scene;
  Recording recording;
};

TEST(SilhouetteWarning, IsNoneWhereTheStartFits) {
  FilmedCloth filmed(3);
  for (size_t camera = 0; camera < 3; ++camera) filmed.AddMask(camera, kStart);
  const std::vector<StartOverlap> overlaps = OverlapsAtStart(filmed.recording);
  ASSERT_EQ(overlaps.size(), 3u);
  for (const StartOverlap& overlap : overlaps)
    EXPECT_GT(overlap.share, 0.97) << overlap.camera;  // a pixel on the rim may go either way
  EXPECT_THAT(filmed.Warnings(), ElementsAre());
}

TEST(SilhouetteWarning, NamesTheWorstCamera) {
  FilmedCloth filmed(3);
  filmed.AddMask(0, kHalfBeside);
  filmed.AddMask(1, kStart);
  filmed.AddMask(2, kBeside);
  EXPECT_THAT(filmed.Warnings(),
              ElementsAre(HasSubstr("in 2 of 3 cameras the cloth does not start where its "
                                    "silhouette is (worst in cam2: 0 % overlap)")));
}

TEST(SilhouetteWarning, IsNoneForHalfOfTheCameras) {
  FilmedCloth filmed(2);
  filmed.AddMask(0, kBeside);
  filmed.AddMask(1, kStart);
  EXPECT_THAT(filmed.Warnings(), ElementsAre());
  filmed.AddMask(1, kBeside);
  EXPECT_THAT(filmed.Warnings(), ElementsAre(HasSubstr("in 2 of 2 cameras")));
}

// Half of a side is 1/3 in common, (1.1 - 0.5) / (1.1 + 0.5) where both are grown; a quarter 0.63.
TEST(SilhouetteWarning, TellsAHalfFromAQuarterOfTheSide) {
  FilmedCloth filmed(1);
  filmed.AddMask(0, kHalfBeside);
  EXPECT_NEAR(OverlapsAtStart(filmed.recording).at(0).share, 0.38, 0.05);
  EXPECT_EQ(filmed.Warnings().size(), 1u);
  filmed.AddMask(0, FlatScene::Placement({0.2, 0.0, 0.0}));
  EXPECT_NEAR(OverlapsAtStart(filmed.recording).at(0).share, 0.63, 0.05);
  EXPECT_THAT(filmed.Warnings(), ElementsAre());
}

// From the side the cloth is 5 px thick and 140 px long: 2 cm move it by almost all of its 5 px.
TEST(SilhouetteWarning, AllowsForSaggingClothSeenFromTheSide) {
  FilmedCloth filmed(1);
  Camera& camera = filmed.recording.cameras[0];
  camera = LookAt({0.4, -1.5, 0.08}, {0.4, 0.3, 0.0});
  const FlatPlacement sagged = FlatScene::Placement({0.0, 0.0, 0.02});
  const cv::Mat start = filmed.scene.Mask(camera, kStart), mask = filmed.scene.Mask(camera, sagged);
  ASSERT_GT(cv::countNonZero(mask), 200);
  ASSERT_LT(cv::countNonZero(start & mask), 0.3 * cv::countNonZero(start | mask));
  filmed.AddMask(0, sagged);
  EXPECT_GT(OverlapsAtStart(filmed.recording).at(0).share, 0.6);
  EXPECT_THAT(filmed.Warnings(), ElementsAre());
  filmed.AddMask(0, FlatScene::Placement({0.0, 0.0, -0.2}));
  EXPECT_EQ(filmed.Warnings().size(), 1u);
}

TEST(SilhouetteWarning, KnowsAStartThatNoCameraSees) {
  FilmedCloth filmed(2);
  filmed.AddMask(0, kStart);
  filmed.AddMask(1, kStart);
  filmed.recording.cloth.initial = FlatScene::Placement({0.0, 0.0, 5.0});  // behind the cameras
  EXPECT_THAT(filmed.Warnings(), ElementsAre(HasSubstr("in 2 of 2 cameras")));
  filmed.recording.cloth.initial = FlatScene::Placement({50.0, 0.0, 0.0});  // beside the pictures
  EXPECT_THAT(filmed.Warnings(), ElementsAre(HasSubstr(": 0 % overlap")));
}

TEST(SilhouetteWarning, GoesByTheFirstMaskIfItIsEarly) {
  FilmedCloth filmed(1);
  filmed.AddMask(0, kStart, 5);
  filmed.AddMask(0, kBeside, 2);
  EXPECT_EQ(filmed.Warnings().size(), 1u);
  filmed.recording.files[0].masks.clear();
  filmed.AddMask(0, kBeside, 4);  // after 0.13 s
  EXPECT_TRUE(OverlapsAtStart(filmed.recording).empty());
}

TEST(SilhouetteWarning, LeavesOutWhatShowsNoCloth) {
  FilmedCloth filmed(2);
  const Camera& camera = filmed.recording.cameras[0];
  filmed.AddMask(0, FlatScene::Placement({50.0, 0.0, 0.0}));
  filmed.recording.files[1].masks[0] = filmed.folder.Write("bad.png", "no picture");
  EXPECT_TRUE(OverlapsAtStart(filmed.recording).empty());
  filmed.recording.files[0] = {};
  filmed.recording.files[0].images[0] =
      filmed.Write("image.png", filmed.scene.Render(camera, kBeside, {}));
  EXPECT_TRUE(OverlapsAtStart(filmed.recording).empty());  // which of it is cloth is not known
  filmed.recording.files.clear();
  EXPECT_THAT(filmed.Warnings(), ElementsAre());
}

TEST(SilhouetteWarning, FindsTheClothInThePicture) {
  FilmedCloth filmed(1);
  const Camera& camera = filmed.recording.cameras[0];
  CameraFiles& files = filmed.recording.files[0];
  files.background =
      filmed.Write("empty.png", filmed.scene.RenderEmpty(camera, {1.0, 0.5, 1.0, 99}));
  files.images[0] =
      filmed.Write("image.png", filmed.scene.Render(camera, kStart, {1.0, 1.0, 1.0, 3}));
  const std::vector<StartOverlap> overlaps = OverlapsAtStart(filmed.recording);
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_GT(overlaps[0].share, 0.95);  // 2 % is what the mask may be off by
  filmed.recording.cloth.initial = kHalfBeside;
  EXPECT_EQ(filmed.Warnings().size(), 1u);
}

TEST(SilhouetteWarning, TakesAPictureOfOnePixel) {
  FilmedCloth filmed(1);
  Camera& camera = filmed.recording.cameras[0];
  camera.width = camera.height = 1;
  CameraFiles& files = filmed.recording.files[0];
  files.background = filmed.Write("empty.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(10)));
  files.images[0] = filmed.Write("image.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(200)));
  EXPECT_TRUE(OverlapsAtStart(filmed.recording).empty());
}

TEST(SilhouetteWarning, IsSaidWhereMarkersHaveNotSaidIt) {
  FilmedCloth filmed(1);
  filmed.AddMask(0, kStart);
  filmed.recording.cloth.initial = kBeside;
  for (const Eigen::Vector2d& uv : {Eigen::Vector2d(0, 0), {0.8, 0}, {0, 0.6}, {0.8, 0.6}}) {
    const int id = static_cast<int>(filmed.recording.markers.size());
    filmed.recording.markers.push_back({0, id, uv, {uv.x(), uv.y(), 0.0}});
  }
  std::vector<std::string> warnings;
  WarnOfPlacement(filmed.recording, &warnings);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("4 of 4 markers begin farther than")));
  warnings.clear();
  filmed.recording.markers.clear();
  WarnOfPlacement(filmed.recording, &warnings);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("in 1 of 1 cameras")));
}

}  // namespace
}  // namespace clothfit
