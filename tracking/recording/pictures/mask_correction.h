// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Masks as they would have been a part of a frame earlier or later, or less fat.
#pragma once

#include <opencv2/core/mat.hpp>

namespace clothfit {

// The mask at `share` (0 to 1) of the way from one mask to the next, its outline moved inwards by
// `thinner` px (outwards where negative): the zero set of what the signed distances to both
// outlines come to in between, which is right where an outline is straight over as far as it moves,
// and wrong where a part moves by more than its own width.
// Both masks: 8-bit, of one size, 0 = background, some of either cloth. Returns 255 where cloth is.
cv::Mat MaskBetween(const cv::Mat& mask, const cv::Mat& next, double share, double thinner);

}  // namespace clothfit
