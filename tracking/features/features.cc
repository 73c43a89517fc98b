// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/features.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace clothfit {

double Features::Distance(int feature, const cv::Mat& descriptor) const {
  return cv::norm(descriptors.row(feature), descriptor, cv::NORM_L2);
}

Features DetectFeatures(const cv::Mat& image, const cv::Mat& mask, const FeatureOptions& options) {
  // Only where the mask is: the rest of the picture costs as much and gives nothing.
  constexpr int kMargin = 24;
  cv::Rect box(0, 0, image.cols, image.rows);
  if (!mask.empty()) {
    const cv::Rect inner = cv::boundingRect(mask);
    if (inner.empty()) return {};
    box &= cv::Rect(inner.x - kMargin, inner.y - kMargin, inner.width + 2 * kMargin,
                    inner.height + 2 * kMargin);
  }
  cv::Mat grey;
  cv::cvtColor(image(box), grey, cv::COLOR_BGR2GRAY);
  const cv::Ptr<cv::SIFT> sift = cv::SIFT::create(options.max_features, 3, options.contrast);
  std::vector<cv::KeyPoint> found;
  cv::Mat part = mask.empty() ? cv::Mat() : mask(box);
  sift->detect(grey, found, part);
  // A corner may come with several orientations; all are kept, in an order of their own.
  std::sort(found.begin(), found.end(), [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
    return std::tie(b.response, a.pt.y, a.pt.x, a.size, a.angle) <
           std::tie(a.response, b.pt.y, b.pt.x, b.size, b.angle);
  });
  Features features;
  sift->compute(grey, found, features.descriptors);
  // SIFT doubles the picture first, and OpenCV before 4.8 takes the pixel 2 p of the doubled one
  // for p; but what was at p lies at 2 p + 1/2 there.
  constexpr double kBias = 0.25;  // px
  for (const cv::KeyPoint& k : found) {
    features.pixels.emplace_back(static_cast<double>(k.pt.x) + box.x - kBias,
                                 static_cast<double>(k.pt.y) + box.y - kBias);
  }
  return features;
}

}  // namespace clothfit
