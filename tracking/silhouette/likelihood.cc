// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/likelihood.h"

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

// How a colour compares with that of the lit background at its pixel.
struct Comparison {
  Comparison(const cv::Vec3b& colour, const cv::Vec3f& lit) {
    double along = 0.0, squared_lit = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double i = colour[c], b = lit[c];
      along += i * b;
      squared_lit += b * b;
      squared += i * i;
      to_lit += (i - b) * (i - b);
    }
    share = squared_lit > 0.0 ? along / squared_lit : 1.0;
    across = std::max(0.0, squared - along * share);
    length = std::max(1.0, std::sqrt(squared_lit));
  }
  // Of the noise across the background's colour: shadows come with some colour of their own, of the
  // light that is left.
  double VarianceAcross(double sigma) const { return sigma * sigma + 1e-4 * squared; }

  double to_lit = 0.0;   // squared distance from the lit background
  double share = 1.0;    // of the light, if it were in shadow
  double across = 0.0;   // squared distance from the background's colour, however dark
  double squared = 0.0;  // squared length of the colour
  double length = 1.0;   // of the lit background's
};

int ShadowBin(double share) {
  return std::clamp(static_cast<int>(share * kShadowBins), 0, kShadowBins - 1);
}

// log p(colour | background): lit as the empty scene is, or in shadow, or a surprise.
double LogBackground(const cv::Vec3b& colour, const cv::Vec3f& lit, double sigma,
                     const cv::Mat& shadows) {
  const Comparison compared(colour, lit);
  const double log_noise = -std::log(sigma) - kLogDensityOfNoise;
  double density = std::exp(3.0 * log_noise - compared.to_lit / (2.0 * sigma * sigma));
  if (compared.share > 0.0 && compared.share < 1.0) {
    const double variance = compared.VarianceAcross(sigma);
    density += shadows.at<float>(ShadowBin(compared.share)) / compared.length *
               std::exp(-2.0 * kLogDensityOfNoise - compared.across / (2.0 * variance)) / variance;
  }
  return std::log(density + kSurprise / kVolume);
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

cv::Mat GuessShadows(double darkest) {
  constexpr float kInShadow = 0.15F;  // of the background
  cv::Mat shadows(kShadowBins, 1, CV_32F, cv::Scalar(0.0));
  const int first = ShadowBin(darkest);
  shadows.rowRange(first, kShadowBins) =
      kInShadow * kShadowBins / static_cast<float>(kShadowBins - first);
  return shadows;
}

cv::Mat LearnShadows(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& mask) {
  constexpr double kFar = 25.0, kNear = 9.0;  // squared sigmas
  constexpr float kUnseen = 0.005F;           // density where nothing was seen
  cv::Mat counts(kShadowBins, 1, CV_32F, cv::Scalar(0.0));
  float total = 1.0F;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (mask.at<uchar>(y, x) != 0) continue;
      total += 1.0F;
      const Comparison compared(image.at<cv::Vec3b>(y, x), lit.at<cv::Vec3f>(y, x));
      if (compared.to_lit < kFar * sigma * sigma || compared.share <= 0.0 ||
          compared.share >= 1.0 || compared.across > kNear * compared.VarianceAcross(sigma)) {
        continue;
      }
      counts.at<float>(ShadowBin(compared.share)) += 1.0F;
    }
  }
  cv::Mat shadows(kShadowBins, 1, CV_32F);
  for (int k = 0; k < kShadowBins; ++k) {
    const float near = 0.5F * counts.at<float>(k) + 0.25F * counts.at<float>(std::max(0, k - 1)) +
                       0.25F * counts.at<float>(std::min(kShadowBins - 1, k + 1));
    shadows.at<float>(k) = near / total * kShadowBins + kUnseen;
  }
  return shadows;
}

bool IsLit(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& region) {
  constexpr double kNear = 16.0;  // squared sigmas, of three channels
  int all = 0, near = 0;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (region.at<uchar>(y, x) == 0) continue;
      ++all;
      const Comparison compared(image.at<cv::Vec3b>(y, x), lit.at<cv::Vec3f>(y, x));
      near += compared.to_lit < kNear * sigma * sigma ? 1 : 0;
    }
  }
  return 2 * near > all;
}

cv::Mat LogRatio(const cv::Mat& image, const cv::Mat& lit, double sigma, const cv::Mat& shadows,
                 const cv::Mat& colours) {
  cv::Mat ratio(image.size(), CV_32F);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3b& colour = image.at<cv::Vec3b>(y, x);
      const double density = colours.empty() ? 1.0 / kVolume : colours.at<float>(BinOf(colour));
      const double log_ratio =
          std::log(density) - LogBackground(colour, lit.at<cv::Vec3f>(y, x), sigma, shadows);
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
