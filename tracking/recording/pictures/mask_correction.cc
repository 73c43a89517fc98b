// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/mask_correction.h"

#include <opencv2/core.hpp>

#include "tracking/recording/pictures/signed_distance.h"

namespace clothfit {

cv::Mat MaskBetween(const cv::Mat& mask, const cv::Mat& next, double share, double thinner) {
  cv::Mat distances = SignedDistances(mask);
  if (share > 0.0)
    cv::addWeighted(distances, 1.0 - share, SignedDistances(next), share, 0.0, distances);
  return distances < -thinner;
}

}  // namespace clothfit
