// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the cloth is in a picture, given a picture of the empty scene.
//
// A pixel of the background is the empty scene's times a gain: that of the light, which drifts, or
// less where the cloth throws its shadow. A pixel of the cloth is of any colour, of those seen on
// the cloth before rather. Which of both it is is decided for all pixels at once, by the minimum
// cut that weighs these likelihoods against the length of the outline (Boykov and Jolly 2001).
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace clothfit {

struct SilhouetteOptions {
  double darkest_shadow = 0.25;  // share of the light left in the deepest shadow, as a first guess
  double outline_weight = 3.0;   // cost of an outline through one pixel, as a log-likelihood
  double smallest_part = 0.02;   // parts below this share of the largest are left out
  double small_hole = 0.005;  // share of the largest part; smaller holes are filled, and dark ones
};

struct Silhouette {
  cv::Mat mask;  // 8-bit: 255 = cloth, 0 = background
  // The outlines (px), outer ones and those of holes, to about a quarter of a pixel.
  std::vector<std::vector<cv::Point2f>> contours;
  // 1 minus the pixels whose surroundings (5 x 5 px) by themselves would be on the other side, over
  // those of the mask; 0 for an empty mask. Below about 0.8 something is wrong.
  double quality = 0.0;
};

// The silhouettes of one camera, frame by frame: what the cloth looks like is learnt from those
// before.
class SilhouetteExtractor {
 public:
  // `background`: 8-bit BGR.
  explicit SilhouetteExtractor(const cv::Mat& background, const SilhouetteOptions& options = {});

  // `image`: 8-bit BGR of the background's size.
  Silhouette Extract(const cv::Mat& image);

 private:
  SilhouetteOptions options_;
  cv::Mat background_;  // float BGR
  cv::Mat colours_;     // histogram of the cloth's colours, empty before the first frame
};

// The outlines of a mask that was made otherwise: those between its pixels.
std::vector<std::vector<cv::Point2f>> ContoursOf(const cv::Mat& mask);

}  // namespace clothfit
