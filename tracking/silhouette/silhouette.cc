// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/silhouette.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include "tracking/silhouette/likelihood.h"

namespace clothfit {
namespace {

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

// Large holes through which the lit floor is seen are holes. Dark ones are dark parts of the cloth
// rather: they look like a shadow, but a shadow that the cloth surrounds is rare.
void FillDarkHoles(const cv::Mat& image, const cv::Mat& lit, double sigma, cv::Mat* mask) {
  cv::Mat labels, stats, centres;
  const int parts = cv::connectedComponentsWithStats(255 - *mask, labels, stats, centres, 4);
  for (int p = 1; p < parts; ++p) {
    const cv::Rect box(stats.at<int>(p, cv::CC_STAT_LEFT), stats.at<int>(p, cv::CC_STAT_TOP),
                       stats.at<int>(p, cv::CC_STAT_WIDTH), stats.at<int>(p, cv::CC_STAT_HEIGHT));
    const bool at_border =
        box.x == 0 || box.y == 0 || box.br().x == mask->cols || box.br().y == mask->rows;
    if (at_border) continue;
    const cv::Mat hole = labels(box) == p;
    if (!IsLit(image(box), lit(box), sigma, hole)) (*mask)(box).setTo(255, hole);
  }
}

void KeepLargeParts(const SilhouetteOptions& options, cv::Mat* mask) {
  cv::Mat labels, stats, centres;
  const int parts = cv::connectedComponentsWithStats(*mask, labels, stats, centres, 8);
  int largest = 0;
  for (int p = 1; p < parts; ++p) largest = std::max(largest, stats.at<int>(p, cv::CC_STAT_AREA));
  const double least = options.smallest_part * largest;
  const double small_hole = options.small_hole * largest;
  cv::Mat holes, hole_stats;
  const cv::Mat inverse = 255 - *mask;
  cv::connectedComponentsWithStats(inverse, holes, hole_stats, centres, 4);
  for (int y = 0; y < mask->rows; ++y) {
    for (int x = 0; x < mask->cols; ++x) {
      uchar& pixel = mask->at<uchar>(y, x);
      const int part = labels.at<int>(y, x), hole = holes.at<int>(y, x);
      if (pixel != 0 && stats.at<int>(part, cv::CC_STAT_AREA) < least) pixel = 0;
      if (pixel == 0 && part == 0 && hole_stats.at<int>(hole, cv::CC_STAT_AREA) <= small_hole)
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
cv::Mat PixelCoverage(const cv::Mat& image, const cv::Mat& mask) {
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
  const int rounds = colours_.empty() ? 4 : 2;
  // Where there are shadows they come and go: each frame finds its own.
  cv::Mat shadows = GuessShadows(options_.darkest_shadow);
  for (int round = 0; round < rounds; ++round) {
    ratio = LogRatio(image, lit, sigma, shadows, colours_);
    result.mask = cv::Mat::zeros(image.size(), CV_8U);
    const cv::Rect box = WhereCloth(ratio);
    if (box.empty()) break;
    MinimumCut(ratio(box), options_.outline_weight).copyTo(result.mask(box));
    FillDarkHoles(image, lit, sigma, &result.mask);
    KeepLargeParts(options_, &result.mask);
    shadows = LearnShadows(image, lit, sigma, result.mask);
    colours_ = LearnColours(image, result.mask);
  }
  result.quality = Quality(result.mask, ratio);
  result.contours = Contours(PixelCoverage(image, result.mask));
  return result;
}

std::vector<std::vector<cv::Point2f>> ContoursOf(const cv::Mat& mask) {
  cv::Mat coverage;
  mask.convertTo(coverage, CV_32F, 1.0 / 255.0);
  return Contours(coverage);
}

}  // namespace clothfit
