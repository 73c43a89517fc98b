// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette_likelihood.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>

namespace clothfit {
namespace {

constexpr int kBins = 16;                            // of the histogram, a channel
constexpr double kVolume = 256.0 * 256.0 * 256.0;    // of all colours
constexpr double kSurprise = 0.02;                   // share of pixels that no model foresees
constexpr double kLogDensityOfNoise = 0.9189385332;  // log sqrt(2 pi)
constexpr float kMostCertain = 20.0F;                // log-likelihood ratios are cut off there

int BinOf(const cv::Vec3b& colour) {
  constexpr int kWidth = 256 / kBins;
  return (colour[0] / kWidth * kBins + colour[1] / kWidth) * kBins + colour[2] / kWidth;
}

// log p(colour | background): lit as the empty scene is, or in shadow, or a surprise.
double LogBackground(const cv::Vec3b& colour, const cv::Vec3f& lit, double sigma,
                     double darkest_shadow) {
  double along = 0.0, size = 0.0, squared = 0.0, to_lit = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double i = colour[c], b = lit[c];
    along += i * b;
    size += b * b;
    squared += i * i;
    to_lit += (i - b) * (i - b);
  }
  constexpr double kShadow = 0.15;  // share of the background in shadow
  const double variance = sigma * sigma;
  const double log_noise = -std::log(sigma) - kLogDensityOfNoise;
  const double lit_density =
      (1.0 - kShadow) * std::exp(3.0 * log_noise - to_lit / (2.0 * variance));
  const double share = size > 0.0 ? along / size : 1.0;
  double shadow_density = 0.0;
  if (share > darkest_shadow && share < 1.0) {
    // Uniform along the colour of the floor, noise across it; shadows come with some texture of
    // their own (ambient light of another colour).
    const double across = std::max(0.0, squared - along * share);
    const double variance_across = variance + 1e-4 * squared;
    const double range = std::max(1.0, (1.0 - darkest_shadow) * std::sqrt(size));
    shadow_density = kShadow *
                     std::exp(-2.0 * kLogDensityOfNoise - across / (2.0 * variance_across)) /
                     (variance_across * range);
  }
  return std::log(lit_density + shadow_density + kSurprise / kVolume);
}

}  // namespace

cv::Vec3f FindGain(const cv::Mat& image, const cv::Mat& background) {
  constexpr int kSteps = 240, kStride = 3;
  constexpr float kLargest = 2.0F, kDark = 20.0F;
  cv::Vec3f gain;
  for (int c = 0; c < 3; ++c) {
    std::vector<float> counts(kSteps, 0.0F);
    for (int y = 0; y < image.rows; y += kStride) {
      for (int x = 0; x < image.cols; x += kStride) {
        const float b = background.at<cv::Vec3f>(y, x)[c];
        const uchar i = image.at<cv::Vec3b>(y, x)[c];
        if (b < kDark || i > 250) continue;
        const int bin = static_cast<int>(static_cast<float>(i) / b / kLargest * kSteps);
        if (bin < kSteps) counts[bin] += b;
      }
    }
    // The mean over the window of 10 % that weighs most.
    constexpr int kHalf = 6;
    float best = 0.0F, mean = 1.0F;
    for (int k = kHalf; k < kSteps - kHalf; ++k) {
      float weight = 0.0F, sum = 0.0F;
      for (int j = k - kHalf; j <= k + kHalf; ++j) {
        weight += counts[j];
        sum += counts[j] * (static_cast<float>(j) + 0.5F) * kLargest / kSteps;
      }
      if (weight > best) {
        best = weight;
        mean = sum / weight;
      }
    }
    gain[c] = mean;
  }
  return gain;
}

double FindSigma(const cv::Mat& image, const cv::Mat& lit) {
  std::vector<float> differences;
  for (int y = 0; y < image.rows; y += 2) {
    for (int x = 0; x < image.cols; x += 2) {
      for (int c = 0; c < 3; ++c) {
        differences.push_back(std::abs(static_cast<float>(image.at<cv::Vec3b>(y, x)[c]) -
                                       lit.at<cv::Vec3f>(y, x)[c]));
      }
    }
  }
  // The median of the smaller two thirds: the largest third may be cloth and shadow.
  const auto nth = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 3);
  std::nth_element(differences.begin(), nth, differences.end());
  constexpr double kSigmaOfThird = 2.32;  // 1 / the 1/3-quantile of |N(0, 1)|
  return std::max(1.0, kSigmaOfThird * static_cast<double>(*nth));
}

cv::Mat LogRatio(const cv::Mat& image, const cv::Mat& lit, double sigma, double darkest_shadow,
                 const cv::Mat& colours) {
  cv::Mat ratio(image.size(), CV_32F);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3b& colour = image.at<cv::Vec3b>(y, x);
      const double density = colours.empty() ? 1.0 / kVolume : colours.at<float>(BinOf(colour));
      const double log_ratio =
          std::log(density) - LogBackground(colour, lit.at<cv::Vec3f>(y, x), sigma, darkest_shadow);
      ratio.at<float>(y, x) =
          std::clamp(static_cast<float>(log_ratio), -kMostCertain, kMostCertain);
    }
  }
  return ratio;
}

cv::Mat LearnColours(const cv::Mat& image, const cv::Mat& mask) {
  constexpr int kSizes[] = {kBins, kBins, kBins};
  cv::Mat counts(kBins * kBins * kBins, 1, CV_32F, cv::Scalar(0.0));
  float total = 0.0F;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (mask.at<uchar>(y, x) == 0) continue;
      counts.at<float>(BinOf(image.at<cv::Vec3b>(y, x))) += 1.0F;
      total += 1.0F;
    }
  }
  if (total == 0.0F) return {};
  cv::Mat smooth(kBins * kBins * kBins, 1, CV_32F, cv::Scalar(0.0));
  const auto at = [&](const cv::Mat& m, int b, int g, int r) {
    return m.at<float>((std::clamp(b, 0, kSizes[0] - 1) * kBins + std::clamp(g, 0, kBins - 1)) *
                           kBins +
                       std::clamp(r, 0, kBins - 1));
  };
  constexpr float kNewColours = 0.2F;
  const float volume = static_cast<float>(kVolume) / (kBins * kBins * kBins);
  for (int b = 0; b < kBins; ++b) {
    for (int g = 0; g < kBins; ++g) {
      for (int r = 0; r < kBins; ++r) {
        const float near =
            0.4F * at(counts, b, g, r) +
            0.1F * (at(counts, b - 1, g, r) + at(counts, b + 1, g, r) + at(counts, b, g - 1, r) +
                    at(counts, b, g + 1, r) + at(counts, b, g, r - 1) + at(counts, b, g, r + 1));
        smooth.at<float>((b * kBins + g) * kBins + r) =
            (1.0F - kNewColours) * near / total / volume +
            kNewColours / static_cast<float>(kVolume);
      }
    }
  }
  return smooth;
}

}  // namespace clothfit
