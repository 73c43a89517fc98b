// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/point_tracker.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/flat_scene.h"

namespace clothfit {
namespace {

// A cloth that slides and turns under a camera.
class PointTrackerTest : public testing::Test {
 protected:
  FlatPlacement At(int frame) const {
    return FlatScene::Placement({0.1 + 0.01 * frame, 0.1 + 0.004 * frame, 0.01 * frame},
                                0.03 * frame);
  }
  cv::Mat Image(int frame) const {
    return scene_.Render(camera_, At(frame), {1.0, 2.0, 1.0, static_cast<unsigned>(frame + 1)});
  }
  cv::Mat Mask(int frame) const { return scene_.Mask(camera_, At(frame)); }
  std::vector<TrackedPoint> Start(PointTracker* tracker) const {
    return tracker->Start(Image(0), Mask(0), camera_, ClothCoordinates(scene_.Place(At(0))));
  }
  std::vector<double> Errors(const std::vector<TrackedPoint>& points, int frame) const {
    std::vector<double> errors;
    for (const TrackedPoint& p : points)
      errors.push_back((scene_.Project(camera_, At(frame), p.uv) - p.pixel).norm());
    std::sort(errors.begin(), errors.end());
    return errors;
  }

  Camera camera_ = LookAt({0.5, 0.3, 1.2}, {0.5, 0.4, 0.0});
  FlatScene scene_;
};

TEST_F(PointTrackerTest, StartsOnTheClothWithTheRightCoordinates) {
  PointTracker tracker;
  const std::vector<TrackedPoint> points = Start(&tracker);
  ASSERT_GT(points.size(), 100U);
  EXPECT_LT(Errors(points, 0).back(), 1e-6);
}

TEST_F(PointTrackerTest, FollowsWithoutDrift) {
  PointTracker tracker;
  const std::size_t first = Start(&tracker).size();
  std::vector<TrackedPoint> points;
  for (int frame = 1; frame <= 10; ++frame) points = tracker.Advance(Image(frame), Mask(frame));
  ASSERT_GT(points.size(), first * 8 / 10);
  const std::vector<double> errors = Errors(points, 10);
  EXPECT_LT(errors[errors.size() / 2], 0.15);  // px, at a noise of 2 grey levels
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.5);
}

TEST_F(PointTrackerTest, LosesWhatIsHiddenAndFindsItAgain) {
  PointTracker tracker;
  Start(&tracker);
  tracker.Advance(Image(1), Mask(1));
  // Something with a texture of its own before the middle, for three frames; the mask does not
  // know.
  const cv::Rect hidden(120, 80, 70, 70);
  std::vector<TrackedPoint> points;
  for (int frame = 2; frame <= 4; ++frame) {
    cv::Mat image = Image(frame);
    cv::Mat noise(hidden.size(), CV_8UC3);
    cv::RNG random(5);
    random.fill(noise, cv::RNG::UNIFORM, 0, 255);
    cv::GaussianBlur(noise, noise, {}, 1.5);
    noise.copyTo(image(hidden));
    points = tracker.Advance(image, Mask(frame));
  }
  int inside = 0;
  constexpr int kHalfWindow = 8;  // px, for what is half hidden
  const cv::Rect core(hidden.x + kHalfWindow, hidden.y + kHalfWindow,
                      hidden.width - 2 * kHalfWindow, hidden.height - 2 * kHalfWindow);
  for (const TrackedPoint& p : points)
    inside += core.contains(cv::Point(cvRound(p.pixel.x()), cvRound(p.pixel.y()))) ? 1 : 0;
  EXPECT_EQ(inside, 0);
  const std::size_t while_hidden = points.size();
  for (int frame = 5; frame <= 6; ++frame) points = tracker.Advance(Image(frame), Mask(frame));
  EXPECT_GT(points.size(), while_hidden + 10);
  EXPECT_GT(tracker.counts().at("found again"), 10);
  EXPECT_LT(Errors(points, 6).back(), 2.0);
}

TEST_F(PointTrackerTest, LosesWhatLeavesTheMask) {
  PointTracker tracker;
  Start(&tracker);
  cv::Mat mask = Mask(1);
  mask.colRange(0, 160).setTo(0);
  for (const TrackedPoint& p : tracker.Advance(Image(1), mask)) EXPECT_GE(p.pixel.x(), 159.0);
  EXPECT_GT(tracker.counts().at("mask"), 10);
}

// A frame that is not there gives nothing, and the points are followed across the gap.
TEST_F(PointTrackerTest, BridgesAMissingFrame) {
  PointTracker tracker;
  Start(&tracker);
  EXPECT_TRUE(tracker.Advance({}, {}).empty());
  const std::vector<TrackedPoint> points = tracker.Advance(Image(2), Mask(2));
  ASSERT_GT(points.size(), 100U);
  const std::vector<double> errors = Errors(points, 2);
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.5);
}

// Each filter alone can be switched off; then it counts nothing.
TEST_F(PointTrackerTest, FiltersCanBeSwitchedOff) {
  PointTrackerOptions options;
  options.check_backward = options.check_move = options.check_neighbours = false;
  options.check_reference = options.redetect = false;
  PointTracker tracker(options);
  Start(&tracker);
  for (int frame = 3; frame <= 9; frame += 3) tracker.Advance(Image(frame), Mask(frame));
  for (const char* what : {"backward", "move", "neighbours", "reference", "found again"})
    EXPECT_EQ(tracker.counts().count(what), 0U) << what;
}

TEST_F(PointTrackerTest, FindsNothingWhereThereIsNothing) {
  PointTracker tracker;
  const cv::Mat grey(camera_.height, camera_.width, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_TRUE(tracker.Start(grey, Mask(0), camera_, ClothCoordinates(scene_.Place(At(0)))).empty());
  EXPECT_TRUE(tracker.Advance(grey, Mask(1)).empty());
}

}  // namespace
}  // namespace clothfit
