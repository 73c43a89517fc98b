// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/silhouette.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/flat_scene.h"

namespace clothfit {
namespace {

double IntersectionOverUnion(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<double>(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

struct View {
  Camera camera = LookAt({0.4, -0.6, 1.2}, {0.4, 0.3, 0.0});
  FlatScene scene;
  FlatPlacement cloth = FlatScene::Placement({0.05, 0.05, 0.0}, 0.2);
};

struct Case {
  const char* name;
  FlatScene::Lighting lighting;
};
class SilhouetteIn : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Light, SilhouetteIn,
                         testing::Values(Case{"clean", {1.0, 0.0, 1.0, 3}},
                                         Case{"noise", {1.0, 5.0, 1.0, 4}},
                                         Case{"shadow", {1.0, 2.0, 0.45, 5}},
                                         Case{"dimmer", {0.88, 2.0, 0.6, 6}},
                                         Case{"brighter", {1.1, 2.0, 0.6, 7}}),
                         [](const auto& one) { return one.param.name; });

TEST_P(SilhouetteIn, IsTheCloths) {
  const View view;
  SilhouetteExtractor extractor(view.scene.RenderEmpty(view.camera, {1.0, 0.5, 1.0, 99}));
  const cv::Mat truth = view.scene.Mask(view.camera, view.cloth);
  const Silhouette found =
      extractor.Extract(view.scene.Render(view.camera, view.cloth, GetParam().lighting));
  // The shadow beside the cloth covers 15 % as much: taken for cloth, 0.87 would be left. An
  // outline off by half a pixel all around costs 0.8 %.
  EXPECT_GT(IntersectionOverUnion(found.mask, truth), 0.98);
  EXPECT_GT(found.quality, 0.9);
}

TEST(Silhouette, OfAnEmptySceneIsEmpty) {
  const View view;
  const FlatScene::Lighting light{1.0, 3.0, 1.0, 1};
  SilhouetteExtractor extractor(view.scene.RenderEmpty(view.camera, light));
  FlatScene::Lighting other = light;
  other.seed = 2;
  const Silhouette found = extractor.Extract(view.scene.RenderEmpty(view.camera, other));
  EXPECT_EQ(cv::countNonZero(found.mask), 0);
  EXPECT_EQ(found.quality, 0.0);
  EXPECT_TRUE(found.contours.empty());
}

// The outline between two colours, to a fraction of a pixel.
TEST(Silhouette, HasAnOutlineFinerThanPixels) {
  const cv::Point2d centre(60.3, 50.7);
  constexpr double kRadius = 30.4;
  cv::Mat background(100, 120, CV_8UC3, cv::Scalar(60, 70, 60)), image = background.clone();
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double inside = kRadius - std::hypot(x - centre.x, y - centre.y);
      const double share = std::clamp(inside + 0.5, 0.0, 1.0);  // of the pixel that is covered
      image.at<cv::Vec3b>(y, x) = cv::Vec3b(static_cast<uchar>(std::lround(60 + 20 * share)),
                                            static_cast<uchar>(std::lround(70 + 40 * share)),
                                            static_cast<uchar>(std::lround(60 + 150 * share)));
    }
  }
  SilhouetteExtractor extractor(background);
  const Silhouette found = extractor.Extract(image);
  ASSERT_EQ(found.contours.size(), 1U);
  double sum = 0.0;
  for (const cv::Point2f& p : found.contours[0])
    sum += std::pow(std::hypot(p.x - centre.x, p.y - centre.y) - kRadius, 2);
  // Points stand a quarter of a pixel apart; those of the mask's own pixels would be 0.3 px off.
  EXPECT_LT(std::sqrt(sum / static_cast<double>(found.contours[0].size())), 0.18);
}

TEST(Silhouette, KeepsLargePartsAndFillsSmallHoles) {
  cv::Mat background(120, 160, CV_8UC3, cv::Scalar(90, 90, 90)), image = background.clone();
  const cv::Scalar red(20, 20, 200);
  cv::rectangle(image, {10, 10, 60, 60}, red, cv::FILLED);
  cv::rectangle(image, {100, 20, 30, 40}, red, cv::FILLED);  // another part of the cloth
  cv::rectangle(image, {30, 30, 3, 3}, {90, 90, 90}, cv::FILLED);
  cv::rectangle(image, {140, 100, 4, 4}, red, cv::FILLED);           // a speck
  cv::rectangle(image, {45, 45, 16, 16}, {90, 90, 90}, cv::FILLED);  // a real hole
  const cv::Mat mask = SilhouetteExtractor(background).Extract(image).mask;
  EXPECT_EQ(mask.at<uchar>(31, 31), 255);
  EXPECT_EQ(mask.at<uchar>(40, 115), 255);
  EXPECT_EQ(mask.at<uchar>(102, 142), 0);
  EXPECT_EQ(mask.at<uchar>(53, 53), 0);
  EXPECT_EQ(ContoursOf(mask).size(), 3U);  // two parts and a hole
}

}  // namespace
}  // namespace clothfit
