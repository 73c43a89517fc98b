// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/clouds/clouds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/test_folder.h"
#include "tracking/recording/warnings/summary.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;
using CloudPoints = std::vector<Vector3d>;
using testing::HasSubstr;

// A cloth that is seen by a camera 2 m above it, which has clouds of its own.
TestFiles CloudRecordingFiles() {
  return {{"recording.yaml",
           "format: cloth-recording/1\nname: seen\nframe_rate: 30\nframe_count: 3\n"
           "gravity: [0, 0, -9.81]\ncloth:\n  size: [1, 1]\n  resolution: [5, 5]\n"
           "  initial: {origin: [0, 0, 0], u_axis: [1, 0, 0], v_axis: [0, 1, 0]}\n"
           "clouds: {camera: above}\ndepth:\n  - {camera: above, scale: 0.001}\n"
           "noise: {cloud: 0.004, cloud_spacing: 0.02}\n"},
          {"cameras.yaml",
           "cameras:\n  - name: above\n    size: [8, 6]\n    K: [4, 0, 3.5, 0, 4, 2.5, 0, 0, 1]\n"
           "    R: [1, 0, 0, 0, -1, 0, 0, 0, -1]\n    t: [0, 0, 2]\n"},
          {"clouds/000001.csv", "x,y,z\n0.5,0.5,0\n0.25,0.5,0.1\n"}};
}

void WritePicture(const TestFolder& folder, const std::string& name, const cv::Mat& picture) {
  std::filesystem::create_directories((folder.path() / name).parent_path());
  ASSERT_TRUE(cv::imwrite((folder.path() / name).string(), picture));
}

TEST(Clouds, AreRead) {
  const TestFolder folder;
  WriteFiles(CloudRecordingFiles(), folder);
  const Recording recording = ReadRecording(folder.path());
  EXPECT_TRUE(HasClouds(recording));
  EXPECT_EQ(recording.clouds.camera, "above");
  EXPECT_EQ(recording.noise.cloud, 0.004);
  EXPECT_EQ(recording.noise.cloud_spacing, 0.02);
  EXPECT_EQ(LoadCloud(recording, 1), (CloudPoints{{0.5, 0.5, 0.0}, {0.25, 0.5, 0.1}}));
  EXPECT_TRUE(LoadCloud(recording, 0).empty());
  EXPECT_THAT(DescribeRecording(recording), HasSubstr("1 of 3 frames (1..1), seen by above"));
  EXPECT_EQ(FilesOf(recording).at("recording.yaml"),
            FilesOf(ReadRecording(folder.path())).at("recording.yaml"));
  const std::string written = FilesOf(recording).at("recording.yaml");
  EXPECT_THAT(written, HasSubstr("clouds: {camera: above}"));
  EXPECT_THAT(written, HasSubstr("{camera: above, scale: 0.001}"));
}

// Along the view, whatever the lens does; without a mask all that is known, with one the cloth.
TEST(Clouds, AreMadeOfDepthPictures) {
  const TestFolder folder;
  WriteFiles(CloudRecordingFiles(), folder);
  cv::Mat depth(6, 8, CV_16UC1, cv::Scalar(0));
  depth.at<std::uint16_t>(1, 6) = 1900;
  depth.at<std::uint16_t>(4, 2) = 65535;
  WritePicture(folder, "depth/above/000000.png", depth);
  WritePicture(folder, "depth/above/000002.png", depth);
  cv::Mat mask(6, 8, CV_8UC1, cv::Scalar(0));
  mask.at<std::uint8_t>(1, 6) = 255;
  WritePicture(folder, "masks/above/000002.png", mask);
  Recording recording = ReadRecording(folder.path());
  EXPECT_EQ(recording.files[0].depth.size(), 2u);
  const CloudPoints points = LoadDepth(recording, 0, 0);
  ASSERT_EQ(points.size(), 2u);
  // (6 - 3.5) / 4 and (1 - 2.5) / 4 of 1.9 m; y and z are turned about.
  EXPECT_LT((points[0] - Vector3d(1.1875, 0.7125, 0.1)).norm(), 1e-12);
  EXPECT_EQ(LoadDepth(recording, 0, 2), CloudPoints{points[0]});
  EXPECT_TRUE(LoadDepth(recording, 0, 1).empty());
  recording.cameras[0].distortion = {-0.1, 0.02, 0.001, -0.001, 0.0};
  for (const Vector3d& point : LoadDepth(recording, 0, 0)) {
    const Eigen::Vector2d pixel = ProjectPoint(recording.cameras[0], point);
    EXPECT_GT(depth.at<std::uint16_t>(static_cast<int>(std::lround(pixel.y())),
                                      static_cast<int>(std::lround(pixel.x()))),
              0);
    EXPECT_LT((pixel - pixel.array().round().matrix()).norm(), 1e-9);
  }
}

TEST(Clouds, AreRefusedWhereTheyCannotBe) {
  const auto error_with = [](const std::string& file, const std::string& text,
                             const std::string& drop = "") {
    const TestFolder folder;
    TestFiles files = CloudRecordingFiles();
    if (!drop.empty()) {
      std::string& yaml = files.at("recording.yaml");
      yaml.replace(yaml.find(drop), drop.size(), text);
    } else {
      files[file] = text;
    }
    WriteFiles(files, folder);
    if (!drop.empty() && file == "depth")
      WritePicture(folder, "depth/above/000000.png", cv::Mat(6, 8, CV_16UC1, cv::Scalar(1)));
    return InputErrorOf([&] { LoadCloud(ReadRecording(folder.path()), 1); });
  };
  EXPECT_THAT(error_with("clouds/1.ply", ""), HasSubstr("six digits such as 000042.ply or"));
  EXPECT_THAT(error_with("clouds/000003.ply", ""), HasSubstr("frame 3 is outside 0..2"));
  EXPECT_THAT(error_with("clouds/000001.pcd", ""), HasSubstr("is the second of its frame"));
  EXPECT_THAT(error_with("clouds/000001.csv", "x,y,z\n0,0,20000\n"), HasSubstr("expected metres"));
  EXPECT_THAT(error_with("", "below}", "above}"), HasSubstr("clouds.camera: 'below' is no camera"));
  EXPECT_THAT(error_with("", "scale: 0}", "scale: 0.001}"), HasSubstr("scale of 'above'"));
  EXPECT_THAT(error_with("", "cloud_spacing: 0", "cloud_spacing: 0.02"),
              HasSubstr("noise.cloud_spacing"));
  EXPECT_THAT(error_with("depth", "", "depth:\n  - {camera: above, scale: 0.001}\n"),
              HasSubstr("no scale for the depth pictures of 'above'"));
}

TEST(Clouds, DepthHasSixteenBits) {
  const TestFolder folder;
  WriteFiles(CloudRecordingFiles(), folder);
  WritePicture(folder, "depth/above/000000.png", cv::Mat(6, 8, CV_8UC1, cv::Scalar(100)));
  const Recording recording = ReadRecording(folder.path());
  const std::string error = InputErrorOf([&] { LoadDepth(recording, 0, 0); });
  EXPECT_THAT(error, HasSubstr("expected one channel of 16 bits, found 1 of 8"));
}

TEST(ThinPoints, KeepsOneOfEachCellAndNoMoreThanWanted) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  CloudPoints points;
  for (int i = 0; i < 20000; ++i) {
    const double y = uniform(random), x = uniform(random);
    points.emplace_back(x, y, 0.0);
  }
  const ThinnedPoints fine = ThinPoints(points, 0.05, 1000);
  EXPECT_EQ(fine.spacing, 0.05);
  EXPECT_EQ(fine.points.size(), 400u);
  const ThinnedPoints coarse = ThinPoints(points, 0.05, 100);
  EXPECT_LE(coarse.points.size(), 100u);
  EXPECT_GT(coarse.points.size(), 60u);
  EXPECT_GT(coarse.spacing, 0.05);
  const auto cell = [&](const Vector3d& p) {
    return std::pair(std::floor(p.x() / coarse.spacing), std::floor(p.y() / coarse.spacing));
  };
  std::set<std::pair<double, double>> cells;
  for (const Vector3d& point : coarse.points) {
    EXPECT_TRUE(cells.insert(cell(point)).second);
    EXPECT_NE(std::find(points.begin(), points.end(), point), points.end());
  }
  EXPECT_TRUE(ThinPoints({}, 0.05, 100).points.empty());
}

// What is kept of a cell must not lean to one side of a noisy surface.
TEST(ThinPoints, KnowsNothingOfErrors) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  CloudPoints points;
  for (int i = 0; i < 200000; ++i) {
    const double z = 0.012 + 0.002 * normal(random), y = uniform(random), x = uniform(random);
    points.emplace_back(x, y, z);
  }
  const ThinnedPoints thinned = ThinPoints(points, 0.02, 10000);
  double sum = 0.0;
  for (const Vector3d& point : thinned.points) sum += point.z() - 0.012;
  const auto count = static_cast<double>(thinned.points.size());
  EXPECT_GE(count, 2500.0);
  EXPECT_LE(count, 2510.0);  // the next cells begin 4 and 6 sigmas away
  EXPECT_LT(std::abs(sum / count), 4.0 * 0.002 / std::sqrt(count));  // sigmas
}

}  // namespace
}  // namespace clothfit
