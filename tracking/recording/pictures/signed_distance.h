// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The signed distance to the outline of a mask, and points of that outline.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace clothfit {

struct SignedDistance {
  double value = 0.0;  // px; positive outside of the mask
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
};

// px, at every pixel of an 8-bit mask (0 = background): positive outside, to the outline, which
// runs half way between the centres of pixels. Float; at most 10000 where there is no outline.
cv::Mat SignedDistances(const cv::Mat& mask);

// The signed distance between pixels. The field is smoothed by less than a
// pixel, kept at every second pixel around the mask and interpolated by bicubic splines, so that
// its first derivative is continuous; further away the distance to that region is added. Beyond the
// picture's margins the mask is continued as it ends there: what leaves the picture is not outside.
class SignedDistanceField {
 public:
  // `mask`: 8-bit, 0 = background; some of it must be cloth.
  explicit SignedDistanceField(const cv::Mat& mask);

  SignedDistance At(const Eigen::Vector2d& pixel) const;

  // Points of the outline, about `spacing` px apart, outlines of holes among them; none where the
  // mask is cut off by the picture's margin. `mask`: the field's own.
  std::vector<Eigen::Vector2d> Outline(const cv::Mat& mask, double spacing) const;

 private:
  cv::Mat field_;                 // float, px
  Eigen::Vector2d origin_{0, 0};  // px, of the field's first sample
};

}  // namespace clothfit
