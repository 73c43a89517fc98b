// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/pictures/picture.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/small_run.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

class Picture : public testing::Test {
 protected:
  cv::Mat Draw(const PictureOptions& options) const {
    const std::filesystem::path file = folder_.path() / "p.png";
    DrawRun(fitted_, run_, options, file, Overwrite::kAllow);
    return cv::imread(file.string());
  }
  // Pixels without a colour, neither white nor black.
  static int CountGrey(const cv::Mat& image) {
    int count = 0;
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const auto& p = image.at<cv::Vec3b>(y, x);
        const auto [low, high] = std::minmax({p[0], p[1], p[2]});
        count += high - low < 10 && low > 100 && high < 200;
      }
    }
    return count;
  }

  TestFolder folder_;
  RunFolder run_ = RunFolder::Open(MakeSmallRun(folder_.path()));
  FittedRun fitted_ = ReadFittedRun(run_);
};

TEST_F(Picture, ShowsObstaclesThatNoRecordingKnowsOf) {
  PictureOptions options;
  options.frames = {2};
  const int without = CountGrey(Draw(options));
  const auto set = [&](const std::string& name, double value) {
    fitted_.config.parameters.at("obstacle_sphere." + name).value = value;
  };
  // Beside the cloth, so that both are seen.
  const Eigen::VectorXd& x = fitted_.scene.initial;
  const Eigen::Vector3d corner = x.head<3>();
  set("stiffness", 1.0);
  set("radius", 0.1);
  set("x", corner.x() - 0.1);
  set("y", corner.y());
  set("z", corner.z());
  EXPECT_GT(CountGrey(Draw(options)), without + 1000);
}

// A panel's worth of it, however large it is.
TEST_F(Picture, ShowsAPartOfAnObstacleWithoutEnd) {
  PictureOptions options;
  options.frames = {2};
  const int without = CountGrey(Draw(options));
  Eigen::VectorXd points(12);
  points << -1e4, -1e4, 0.0, 1e4, -1e4, 0.0, 1e4, 1e4, 0.0, -1e4, 1e4, 0.0;
  auto floor = std::make_shared<Obstacle>(MakeMeshObstacle(points, {{0, 1, 2}, {0, 2, 3}}));
  RigidPose pose;
  pose.origin_in_world.z() = fitted_.scene.initial[2] - 0.15;
  floor->path = {pose};
  fitted_.scene.world.obstacles = {floor};
  fitted_.config.parameters.at("obstacle.stiffness").value = 0.0;  // to be seen, not met
  EXPECT_GT(CountGrey(Draw(options)), without + 10000);
}

TEST_F(Picture, ShowsWhatIsGivenInTheUpperRow) {
  PictureOptions options;
  options.frames = {2};
  const cv::Mat by_default = Draw(options);
  // All particles in one place: there is nothing to be seen of the cloth.
  options.before.assign(3, Eigen::VectorXd::Zero(fitted_.scene.initial.size()));
  const cv::Mat given = Draw(options);
  const cv::Rect upper(0, 0, options.panel, options.panel);
  const cv::Rect lower(0, options.panel, options.panel, options.panel);
  EXPECT_GT(cv::norm(by_default(upper), given(upper), cv::NORM_L1), 0.0);
  EXPECT_EQ(cv::norm(by_default(lower), given(lower), cv::NORM_L1), 0.0);
  options.frames = {3};
  EXPECT_THROW(Draw(options), std::runtime_error);
}

}  // namespace
}  // namespace clothfit
