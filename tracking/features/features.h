// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Features of a picture, by the Scale Invariant Feature Transform (Lowe 2004; OpenCV's).
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace clothfit {

struct FeatureOptions {
  int max_features = 1500;  // a picture, the strongest
  double contrast = 0.02;   // SIFT's threshold of contrast; lower finds more
};

struct Features {
  std::vector<Eigen::Vector2d> pixels;
  cv::Mat descriptors;  // float, 128 columns, one row a feature; of length 512 or so

  int size() const { return static_cast<int>(pixels.size()); }
  double Distance(int feature, const cv::Mat& descriptor) const;
};

// Those on the mask (an empty one stands for all) of an 8-bit BGR picture, in an order that does
// not depend on threads.
Features DetectFeatures(const cv::Mat& image, const cv::Mat& mask,
                        const FeatureOptions& options = {});

}  // namespace clothfit
