// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/signed_distance.h"

#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace clothfit {
namespace {

// Pixels whose centre lies in the ring between two radii.
cv::Mat Ring(const Eigen::Vector2d& centre, double inner, double outer) {
  cv::Mat mask = cv::Mat::zeros(160, 200, CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const double r = (Eigen::Vector2d(x, y) - centre).norm();
      if (r >= inner && r <= outer) mask.at<std::uint8_t>(y, x) = 255;
    }
  }
  return mask;
}

TEST(SignedDistanceField, IsTheDistanceToADisc) {
  const Eigen::Vector2d centre(100.3, 80.6);
  const SignedDistanceField field(Ring(centre, -1.0, 40.2));
  double bias = 0.0;
  int count = 0;
  for (double angle = 0.0; angle < 6.28; angle += 0.11) {
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    for (const double distance :
         {-25.0, -8.3, -1.2, 0.0, 0.7, 3.3, 17.0, 35.0, 45.0, 60.0, 200.0}) {
      const SignedDistance d = field.At(centre + (40.2 + distance) * out);
      if (distance <= 45.0) {
        EXPECT_NEAR(d.value, distance, 0.6);
        EXPECT_GT(d.gradient.dot(out), 0.8);  // the steps of pixels show
        bias += d.value - distance;
        ++count;
      } else {
        // The distance to the field's own region and what it says at its margin.
        EXPECT_NEAR(d.value, distance, 0.35 * distance);
        EXPECT_GT(d.gradient.dot(out), 0.5);
      }
    }
  }
  EXPECT_NEAR(bias / count, 0.0, 0.1);
}

TEST(SignedDistanceField, HasTheGradientOfItsValue) {
  const SignedDistanceField field(Ring({90.0, 70.0}, 12.0, 45.0));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(-80.0, 280.0), y(-80.0, 240.0);
  for (int i = 0; i < 500; ++i) {
    Eigen::Vector2d p;
    p.y() = y(random);
    p.x() = x(random);
    const SignedDistance d = field.At(p);
    constexpr double kStep = 1e-5;
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(k);
      const double slope = (field.At(p + step).value - field.At(p - step).value) / (2.0 * kStep);
      EXPECT_NEAR(d.gradient[k], slope, 1e-5);
    }
  }
}

TEST(SignedDistanceField, HasTheOutlinesOfARing) {
  const Eigen::Vector2d centre(100.3, 80.6);
  const cv::Mat mask = Ring(centre, 15.0, 45.0);
  const std::vector<Eigen::Vector2d> outline = SignedDistanceField(mask).Outline(mask, 5.0);
  const double length = 2.0 * M_PI * (15.0 + 45.0);
  EXPECT_NEAR(static_cast<double>(outline.size()), length / 5.0, 0.15 * length / 5.0);
  double bias = 0.0;
  int inner = 0;
  for (const Eigen::Vector2d& p : outline) {
    const double r = (p - centre).norm();
    const double error = r < 30.0 ? r - 15.0 : r - 45.0;
    inner += r < 30.0 ? 1 : 0;
    EXPECT_NEAR(error, 0.0, 0.4);
    bias += error;
  }
  EXPECT_GT(inner, 12);
  EXPECT_NEAR(bias / static_cast<double>(outline.size()), 0.0, 0.08);
}

// A cloth that leaves the picture has no outline where the picture ends.
TEST(SignedDistanceField, DoesNotKnowWhatIsBesideThePicture) {
  const cv::Mat mask = Ring({195.0, 80.0}, -1.0, 30.0);
  const SignedDistanceField field(mask);
  EXPECT_LT(field.At({205.0, 80.0}).value, -5.0);
  EXPECT_GT(field.At({205.0, 125.0}).value, 5.0);
  for (const Eigen::Vector2d& p : field.Outline(mask, 3.0)) EXPECT_LT(p.x(), 198.0);
  const SignedDistanceField full(cv::Mat(160, 200, CV_8UC1, cv::Scalar(255)));
  EXPECT_LT(full.At({100.0, 80.0}).value, 0.0);
  EXPECT_TRUE(full.Outline(cv::Mat(160, 200, CV_8UC1, cv::Scalar(255)), 3.0).empty());
}

}  // namespace
}  // namespace clothfit
