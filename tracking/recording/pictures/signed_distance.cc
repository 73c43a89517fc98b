// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/signed_distance.h"

#include <algorithm>
#include <cmath>

#include <ceres/cubic_interpolation.h>
#include <opencv2/imgproc.hpp>

namespace clothfit {
namespace {

constexpr int kFieldMargin = 48;  // px, what the field covers around the mask
constexpr int kStep = 2;          // px between samples
constexpr double kSmooth = 0.8;   // px, sigma

}  // namespace

cv::Mat SignedDistances(const cv::Mat& mask) {
  const cv::Mat region = mask != 0;
  cv::Mat outside, inside;
  cv::distanceTransform(~region, outside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::distanceTransform(region, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Mat distance(region.size(), CV_32F);
  for (int y = 0; y < distance.rows; ++y) {
    for (int x = 0; x < distance.cols; ++x) {
      // A picture that is all cloth has no outline to be far from.
      constexpr float kFar = 1e4F;
      const float out = std::min(kFar, outside.at<float>(y, x));
      const float in = std::min(kFar, inside.at<float>(y, x));
      distance.at<float>(y, x) = out > 0.0F ? out - 0.5F : 0.5F - in;
    }
  }
  return distance;
}

SignedDistanceField::SignedDistanceField(const cv::Mat& mask) {
  cv::Mat padded;
  cv::copyMakeBorder(mask, padded, kFieldMargin, kFieldMargin, kFieldMargin, kFieldMargin,
                     cv::BORDER_REPLICATE);
  // What reaches the picture's margin goes on beyond it, here as far as the field reaches.
  const cv::Rect cloth = cv::boundingRect(mask);
  const cv::Rect around(cloth.x, cloth.y, cloth.width + 2 * kFieldMargin,
                        cloth.height + 2 * kFieldMargin);
  cv::Mat distance = SignedDistances(padded(around));
  cv::GaussianBlur(distance, distance, cv::Size(), kSmooth, kSmooth, cv::BORDER_REPLICATE);
  field_.create((distance.rows + kStep - 1) / kStep, (distance.cols + kStep - 1) / kStep, CV_32F);
  for (int y = 0; y < field_.rows; ++y) {
    for (int x = 0; x < field_.cols; ++x) {
      field_.at<float>(y, x) = distance.at<float>(kStep * y, kStep * x);
    }
  }
  origin_ = {around.x - kFieldMargin, around.y - kFieldMargin};
}

SignedDistance SignedDistanceField::At(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d last = origin_ + kStep * Eigen::Vector2d(field_.cols - 1, field_.rows - 1);
  const Eigen::Vector2d inside = pixel.cwiseMax(origin_).cwiseMin(last);
  const ceres::Grid2D<float> grid(field_.ptr<float>(), 0, field_.rows, 0, field_.cols);
  const ceres::BiCubicInterpolator<ceres::Grid2D<float>> interpolator(grid);
  SignedDistance result;
  double by_row = 0.0, by_column = 0.0;
  const Eigen::Vector2d sample = (inside - origin_) / kStep;
  interpolator.Evaluate(sample.y(), sample.x(), &result.value, &by_row, &by_column);
  result.gradient = Eigen::Vector2d(by_column, by_row) / kStep;
  const Eigen::Vector2d beyond = pixel - inside;
  const double away = beyond.norm();
  if (away == 0.0) return result;
  result.value += away;
  for (int k = 0; k < 2; ++k) {
    if (beyond[k] != 0.0) result.gradient[k] = 0.0;
  }
  result.gradient += beyond / away;
  return result;
}

std::vector<Eigen::Vector2d> SignedDistanceField::Outline(const cv::Mat& mask,
                                                          double spacing) const {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<Eigen::Vector2d> points;
  for (const std::vector<cv::Point>& contour : contours) {
    double since = spacing;  // the first point is one
    for (std::size_t i = 0; i < contour.size(); ++i) {
      if (i > 0) since += cv::norm(contour[i] - contour[i - 1]);
      if (since < spacing) continue;
      since = 0.0;
      Eigen::Vector2d point(contour[i].x, contour[i].y);
      for (int iteration = 0; iteration < 4; ++iteration) {
        const SignedDistance d = At(point);
        const double slope2 = d.gradient.squaredNorm();
        if (slope2 < 0.04) break;  // a ridge: thinner than the field can tell
        point -= d.value / slope2 * d.gradient;
      }
      constexpr double kCutOff = 1.5;  // px
      const bool is_cut = point.x() < kCutOff || point.y() < kCutOff ||
                          point.x() > mask.cols - 1 - kCutOff ||
                          point.y() > mask.rows - 1 - kCutOff;
      const bool is_near = (point - Eigen::Vector2d(contour[i].x, contour[i].y)).norm() < 2.0;
      if (!is_cut && is_near) points.push_back(point);
    }
  }
  return points;
}

}  // namespace clothfit
