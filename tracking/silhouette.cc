// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

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

// The most frequent quotient of image and background, channel by channel: that of the light, as
// long as the cloth and its shadow cover less than the rest.
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

// Standard deviation (grey levels) of image minus background, robustly, where the cloth is not.
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

// Density of the colours under the mask, smoothed, with a share for colours not seen yet.
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

// The labels of least cost. `ratio`: log-likelihood of cloth minus that of background.
cv::Mat MinimumCut(const cv::Mat& ratio, double outline_weight) {
  cv::detail::GCGraph<float> graph;
  const int pixels = ratio.rows * ratio.cols;
  graph.create(static_cast<unsigned>(pixels), static_cast<unsigned>(8 * pixels));
  const float straight = static_cast<float>(0.5 * outline_weight);
  const float diagonal = straight / std::sqrt(2.0F);
  for (int y = 0; y < ratio.rows; ++y) {
    for (int x = 0; x < ratio.cols; ++x) {
      const int v = graph.addVtx();
      const float r = ratio.at<float>(y, x);
      graph.addTermWeights(v, std::max(0.0F, r), std::max(0.0F, -r));
      if (x > 0) graph.addEdges(v, v - 1, straight, straight);
      if (y == 0) continue;
      const int above = v - ratio.cols;
      graph.addEdges(v, above, straight, straight);
      if (x > 0) graph.addEdges(v, above - 1, diagonal, diagonal);
      if (x + 1 < ratio.cols) graph.addEdges(v, above + 1, diagonal, diagonal);
    }
  }
  graph.maxFlow();
  cv::Mat mask(ratio.size(), CV_8U);
  for (int y = 0; y < ratio.rows; ++y) {
    for (int x = 0; x < ratio.cols; ++x)
      mask.at<uchar>(y, x) = graph.inSourceSegment(y * ratio.cols + x) ? 255 : 0;
  }
  return mask;
}

// The part of the picture in which something may be cloth; the graph is built there only.
cv::Rect WhereCloth(const cv::Mat& ratio) {
  cv::Mat smooth, likely;
  constexpr int kAround = 7, kMargin = 8;
  cv::blur(ratio, smooth, {kAround, kAround});
  cv::threshold(smooth, likely, 0.0, 255.0, cv::THRESH_BINARY);
  likely.convertTo(likely, CV_8U);
  const cv::Rect box = cv::boundingRect(likely);
  if (box.empty()) return box;
  const cv::Rect wider(box.x - kMargin, box.y - kMargin, box.width + 2 * kMargin,
                       box.height + 2 * kMargin);
  return wider & cv::Rect(0, 0, ratio.cols, ratio.rows);
}

void KeepLargeParts(const SilhouetteOptions& options, cv::Mat* mask) {
  cv::Mat labels, stats, centres;
  const int parts = cv::connectedComponentsWithStats(*mask, labels, stats, centres, 8);
  int largest = 0;
  for (int p = 1; p < parts; ++p) largest = std::max(largest, stats.at<int>(p, cv::CC_STAT_AREA));
  const double least = options.smallest_part * largest;
  cv::Mat holes, hole_stats;
  const cv::Mat inverse = 255 - *mask;
  cv::connectedComponentsWithStats(inverse, holes, hole_stats, centres, 4);
  for (int y = 0; y < mask->rows; ++y) {
    for (int x = 0; x < mask->cols; ++x) {
      uchar& pixel = mask->at<uchar>(y, x);
      const int part = labels.at<int>(y, x), hole = holes.at<int>(y, x);
      if (pixel != 0 && stats.at<int>(part, cv::CC_STAT_AREA) < least) pixel = 0;
      if (pixel == 0 && part == 0 &&
          hole_stats.at<int>(hole, cv::CC_STAT_AREA) <= options.largest_hole)
        pixel = 255;
    }
  }
}

double Quality(const cv::Mat& mask, const cv::Mat& log_ratio) {
  constexpr int kAround = 5;
  cv::Mat ratio;
  cv::blur(log_ratio, ratio, {kAround, kAround});
  int area = 0, contradicting = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const bool is_cloth = mask.at<uchar>(y, x) != 0;
      area += is_cloth ? 1 : 0;
      contradicting += is_cloth != (ratio.at<float>(y, x) > 0.0F) ? 1 : 0;
    }
  }
  return area == 0 ? 0.0 : std::max(0.0, 1.0 - static_cast<double>(contradicting) / area);
}

// How far each pixel is covered (0 to 1): at the outline by where its colour lies between those of
// the cloth and of the background beside it, elsewhere by the mask.
cv::Mat Coverage(const cv::Mat& image, const cv::Mat& mask) {
  cv::Mat inner, outer, colour;
  cv::erode(mask, inner, cv::Mat());
  cv::dilate(mask, outer, cv::Mat());
  image.convertTo(colour, CV_32FC3);
  const auto mean_around = [&](const cv::Mat& where) {
    cv::Mat weight, sum, part = cv::Mat::zeros(colour.size(), CV_32FC3);
    colour.copyTo(part, where);
    where.convertTo(weight, CV_32F, 1.0 / 255.0);
    cv::blur(part, sum, {5, 5});
    cv::blur(weight, weight, {5, 5});
    cv::Mat channels[3] = {weight, weight, weight}, weights;
    cv::merge(channels, 3, weights);
    return cv::Mat(sum / (weights + 1e-6));
  };
  const cv::Mat cloth = mean_around(inner), background = mean_around(255 - outer);
  cv::Mat coverage;
  mask.convertTo(coverage, CV_32F, 1.0 / 255.0);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (outer.at<uchar>(y, x) == 0 || inner.at<uchar>(y, x) != 0) continue;
      const cv::Vec3f b = background.at<cv::Vec3f>(y, x), f = cloth.at<cv::Vec3f>(y, x) - b;
      const float size = f.dot(f);
      constexpr float kDistinct = 30.0F;  // grey levels
      if (size < kDistinct * kDistinct) continue;
      const float share = (colour.at<cv::Vec3f>(y, x) - b).dot(f) / size;
      // The cut knows the sides; the colours only say where between them the outline runs.
      const bool is_cloth = mask.at<uchar>(y, x) != 0;
      coverage.at<float>(y, x) =
          is_cloth ? std::clamp(share, 0.5F, 1.0F) : std::clamp(share, 0.0F, 0.5F);
    }
  }
  return coverage;
}

std::vector<std::vector<cv::Point2f>> Contours(const cv::Mat& coverage) {
  constexpr int kFiner = 4;
  cv::Mat finer, mask;
  cv::resize(coverage, finer, {}, kFiner, kFiner, cv::INTER_LINEAR);
  cv::threshold(finer, mask, 0.5, 255.0, cv::THRESH_BINARY);
  mask.convertTo(mask, CV_8U);
  std::vector<std::vector<cv::Point>> found;
  cv::findContours(mask, found, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<std::vector<cv::Point2f>> contours;
  for (const std::vector<cv::Point>& contour : found) {
    std::vector<cv::Point2f> points;
    for (const cv::Point& p : contour) {
      // Resizing aligns the corners of the pictures, not the centres of their pixels.
      points.emplace_back((static_cast<float>(p.x) + 0.5F) / kFiner - 0.5F,
                          (static_cast<float>(p.y) + 0.5F) / kFiner - 0.5F);
    }
    contours.push_back(std::move(points));
  }
  return contours;
}

}  // namespace

SilhouetteExtractor::SilhouetteExtractor(const cv::Mat& background,
                                         const SilhouetteOptions& options)
    : options_(options) {
  background.convertTo(background_, CV_32FC3);
}

Silhouette SilhouetteExtractor::Extract(const cv::Mat& image) {
  const cv::Vec3f gain = FindGain(image, background_);
  cv::Mat lit;
  cv::multiply(background_, cv::Scalar(gain[0], gain[1], gain[2]), lit);
  const double sigma = FindSigma(image, lit);
  Silhouette result;
  cv::Mat ratio;
  const int rounds = colours_.empty() ? 3 : 1;
  for (int round = 0; round < rounds; ++round) {
    ratio = LogRatio(image, lit, sigma, options_.darkest_shadow, colours_);
    result.mask = cv::Mat::zeros(image.size(), CV_8U);
    const cv::Rect box = WhereCloth(ratio);
    if (box.empty()) break;
    MinimumCut(ratio(box), options_.outline_weight).copyTo(result.mask(box));
    KeepLargeParts(options_, &result.mask);
    colours_ = LearnColours(image, result.mask);
  }
  result.quality = Quality(result.mask, ratio);
  result.contours = Contours(Coverage(image, result.mask));
  return result;
}

std::vector<std::vector<cv::Point2f>> ContoursOf(const cv::Mat& mask) {
  cv::Mat coverage;
  mask.convertTo(coverage, CV_32F, 1.0 / 255.0);
  return Contours(coverage);
}

}  // namespace clothfit
