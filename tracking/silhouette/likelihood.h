// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How likely each pixel shows the background, lit or in shadow, and how likely the cloth.
#pragma once

#include <opencv2/core/mat.hpp>

namespace clothfit {

// The gain of the light, channel by channel: the most frequent quotient of image (8-bit BGR) and
// background (float BGR), as long as the cloth and its shadow cover less than the rest.
cv::Vec3f FindGain(const cv::Mat& image, const cv::Mat& background);

// Standard deviation (grey levels) of image minus lit background where the cloth is not, robustly.
double FindSigma(const cv::Mat& image, const cv::Mat& lit);

// How much of the background lies in shadow, by the share of the light that is left there: density
// in kShadowBins equal bins from 0 to 1, float, one column. Its integral is the share in shadow.
inline constexpr int kShadowBins = 20;

// Before anything is known: some, equally from `darkest` on.
cv::Mat GuessShadows(double darkest);
// Read off the background (mask 0), where it is neither lit nor of another colour.
cv::Mat LearnShadows(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& mask);

// log p(colour | cloth) - log p(colour | background), float, cut off at 20. `lit`: the background
// under the present light; `colours`: of the cloth, from LearnColours, empty where nothing is
// known.
cv::Mat LogRatio(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& shadows,
                 const cv::Mat& colours);

// Whether a region (255) of the picture looks like the background under its full light.
bool IsLit(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& region);

// Density of the colours under the mask, smoothed, with a share for colours not seen yet; empty for
// an empty mask.
cv::Mat LearnColours(const cv::Mat& image, const cv::Mat& mask);

}  // namespace clothfit
