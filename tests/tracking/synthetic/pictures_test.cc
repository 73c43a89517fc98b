// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/pictures.h"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/test_folder.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/recording/surface/truth_surface.h"
#include "tracking/synthetic/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

// Two cameras, four frames, of a cloth whose corner is lifted.
SyntheticOptions SmallPictures() {
  SyntheticOptions options;
  options.scenario = SyntheticScenario::kCornerLift;
  options.size = {0.4, 0.4};
  options.resolution = {6, 6};
  options.refinement = 2;
  options.frame_rate = 10.0;
  options.frame_count = 4;
  options.steps_per_frame = 8;
  options.markers = {0, 0};
  options.tracks = false;
  options.num_cameras = 2;
  options.images = true;
  options.truth_points = {11, 11};  // the generator's own
  options.pictures.size = {64, 48};
  options.pictures.threads = 1;
  return options;
}

cv::Mat ReadFrame(const fs::path& folder, const char* kind, const char* camera, int frame) {
  const fs::path file = folder / kind / camera / ("00000" + std::to_string(frame) + ".png");
  return cv::imread(file.string(), cv::IMREAD_UNCHANGED);
}

double Difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(SyntheticPictures, AreTheSameForAnyNumberOfThreads) {
  const TestFolder one, two;
  SyntheticOptions options = SmallPictures();
  Synthesize(options, one.path(), Overwrite::kRefuse);
  options.pictures.threads = 2;
  Synthesize(options, two.path(), Overwrite::kRefuse);
  int compared = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(one.path())) {
    if (entry.path().extension() != ".png") continue;
    const fs::path other = two.path() / fs::relative(entry.path(), one.path());
    EXPECT_EQ(ReadTextFile(entry.path()), ReadTextFile(other)) << other;
    ++compared;
  }
  EXPECT_EQ(compared, 2 * (4 + 4 + 1));  // images, masks, background
}

TEST(SyntheticPictures, MasksAreWhereTheTruthIsSeen) {
  const TestFolder folder;
  Synthesize(SmallPictures(), folder.path(), Overwrite::kRefuse);
  const Recording recording = ReadRecording(folder.path());
  ASSERT_EQ(recording.cameras.size(), 2u);
  EXPECT_EQ(recording.cameras[1].name, "ceiling");
  TruthSurface truth = TruthSurface::Read(folder.path());
  ASSERT_EQ(truth.frame_count(), 4);
  int covered = 0, different = 0;
  for (int frame = 0; frame < 4; ++frame) {
    const ClothSurface& surface = truth.MoveTo(frame);
    for (const Camera& camera : recording.cameras) {
      const cv::Mat mask = ReadFrame(folder.path(), "truth/masks", camera.name.c_str(), frame);
      ASSERT_EQ(mask.type(), CV_8UC1);
      for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
          const bool is_seen = surface.SeenAt(camera, Eigen::Vector2d(x, y)).has_value();
          covered += is_seen ? 1 : 0;
          different += is_seen == (mask.at<uchar>(y, x) == 255) ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(covered, 2000);
  EXPECT_LE(different, 4);  // the truth is rounded to a micrometre
}

TEST(SyntheticPictures, StayInView) {
  const TestFolder folder;
  SyntheticOptions options = SmallPictures();
  options.pictures.distortion = {-0.2, 0.05, 0.001, -0.001, 0.0};
  options.num_cameras = 4;
  const SyntheticRecording synthetic = MakeSyntheticRecording(options);
  ASSERT_EQ(synthetic.recording.cameras.size(), 4u);
  for (const Camera& camera : synthetic.recording.cameras) {
    Eigen::AlignedBox2d extent;
    for (const Eigen::VectorXd& x : synthetic.surface.positions) {
      for (Eigen::Index i = 0; i < x.size(); i += 3)
        extent.extend(ProjectPoint(camera, Eigen::Vector3d(x.segment<3>(i))));
    }
    EXPECT_TRUE(IsInImage(camera, extent.min()) && IsInImage(camera, extent.max()));
    EXPECT_GT((extent.sizes().array() / Eigen::Array2d(64, 48)).maxCoeff(), 0.7) << camera.name;
  }
}

TEST(SyntheticPictures, BackgroundIsTheRoomWithoutTheCloth) {
  const TestFolder folder;
  SyntheticOptions options = SmallPictures();
  options.pictures.light_drift = 0.0;
  options.pictures.noise = 1.0;
  Synthesize(options, folder.path(), Overwrite::kRefuse);
  const cv::Mat background = cv::imread((folder.path() / "background/ceiling.png").string());
  const cv::Mat image = ReadFrame(folder.path(), "images", "ceiling", 0);
  const cv::Mat mask = ReadFrame(folder.path(), "truth/masks", "ceiling", 0);
  cv::Mat away;  // the cloth lies flat, so its shadow is as good as hidden
  cv::dilate(mask, away, cv::Mat::ones(5, 5, CV_8UC1));
  away = 255 - away;
  cv::Mat difference;
  cv::subtract(image, background, difference, cv::noArray(), CV_32F);
  cv::Scalar mean, deviation;
  cv::meanStdDev(difference, mean, deviation, away);
  // Noise of both, and rounding of both; a tenth for the estimate from about a thousand pixels.
  EXPECT_NEAR(deviation[1], std::sqrt(1.0 + 1.0 / 16.0 + 2.0 / 12.0), 0.1);
  EXPECT_NEAR(mean[1], 0.0, 0.15);
  EXPECT_GT(cv::norm(image, background, cv::NORM_INF, mask), 40.0);
}

TEST(SyntheticPictures, ALongExposureIsTheMeanOfItsMoments) {
  const TestFolder sharp, blurred;
  SyntheticOptions options = SmallPictures();
  options.pictures.noise = 0.0;
  Synthesize(options, sharp.path(), Overwrite::kRefuse);
  options.pictures.exposure = 0.05;
  Synthesize(options, blurred.path(), Overwrite::kRefuse);
  const auto at = [](const TestFolder& folder, const char* kind, int frame) {
    return ReadFrame(folder.path(), kind, "cam0", frame);
  };
  EXPECT_GT(Difference(at(sharp, "images", 2), at(blurred, "images", 2)), 10.0);
  EXPECT_EQ(Difference(at(sharp, "truth/masks", 2), at(blurred, "truth/masks", 2)), 0.0);
}

TEST(SyntheticPictures, AVideoReadsBackAsThePictures) {
  const TestFolder folder, filmed;
  SyntheticOptions options = SmallPictures();
  Synthesize(options, folder.path(), Overwrite::kRefuse);
  options.pictures.video = "mkv";
  Synthesize(options, filmed.path(), Overwrite::kRefuse);
  const Recording pictures = ReadRecording(folder.path()), video = ReadRecording(filmed.path());
  EXPECT_FALSE(fs::exists(filmed.path() / "images"));
  for (int frame = 0; frame < 4; ++frame) {
    // FFV1 keeps all; the way there and back through its colours may round.
    EXPECT_LE(Difference(LoadImage(pictures, 1, frame), LoadImage(video, 1, frame)), 2.0);
  }
}

TEST(SyntheticPictures, ReplaceThoseThatWereThere) {
  const TestFolder folder;
  SyntheticOptions options = SmallPictures();
  Synthesize(options, folder.path(), Overwrite::kRefuse);
  EXPECT_THAT(InputErrorOf([&] { Synthesize(options, folder.path(), Overwrite::kRefuse); }),
              HasSubstr("already holds a recording"));
  options.frame_count = 2;
  Synthesize(options, folder.path(), Overwrite::kAllow);
  EXPECT_EQ(ReadRecording(folder.path()).files[0].images.size(), 2u);
  EXPECT_FALSE(fs::exists(folder.path() / "truth/masks/cam0/000003.png"));
}

TEST(SyntheticSurface, IsInterpolatedBetweenItsPositions) {
  const SyntheticSurface surface{
      {}, 0.5, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 0, 5)}};
  EXPECT_EQ(surface.At(-1.0), surface.positions[0]);
  EXPECT_EQ(surface.At(0.5), surface.positions[1]);
  EXPECT_LT((surface.At(0.75) - Eigen::Vector3d(1, 1, 4)).norm(), 1e-12);
  EXPECT_EQ(surface.At(9.0), surface.positions[2]);
}

TEST(TruthSurface, RefusesWhatIsNoGrid) {
  const auto problem_of = [](const std::vector<TruthPoint>& points) {
    return InputErrorOf([&] { TruthSurface(points, "points.csv"); });
  };
  EXPECT_THAT(problem_of({}), HasSubstr("points.csv: expected a grid"));
  std::vector<TruthPoint> points;
  for (const Eigen::Vector2d& uv : {Eigen::Vector2d(0, 0), {1, 0}, {0, 1}})
    points.push_back({0, uv, uv.homogeneous()});
  EXPECT_THAT(problem_of(points), HasSubstr("found 3"));
}

}  // namespace
}  // namespace clothfit
