// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/patch_search.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace clothfit {
namespace {

constexpr int kFewestNeighbours = 5;
// A surface that is seen this much smaller or larger than in the first frame does not look alike.
constexpr double kSmallestScale = 0.25, kLargestScale = 4.0;
constexpr double kLeastContrast = 2.0;  // grey levels

struct MeanAndSpread {
  double mean, spread;
};
MeanAndSpread Describe(const cv::Mat& patch) {
  cv::Scalar mean, spread;
  cv::meanStdDev(patch, mean, spread);
  return {mean[0], spread[0]};
}

double Correlation(const cv::Mat& a, const cv::Mat& b) {
  const MeanAndSpread of_a = Describe(a), of_b = Describe(b);
  if (of_a.spread < kLeastContrast || of_b.spread < kLeastContrast) return -1.0;
  double sum = 0.0;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x)
      sum += (a.at<uchar>(y, x) - of_a.mean) * (b.at<uchar>(y, x) - of_b.mean);
  }
  return sum / (a.rows * a.cols * of_a.spread * of_b.spread);
}

}  // namespace

LocalMotion FitLocalMotion(const cv::Point2f& reference, const std::vector<MovedPoint>& around) {
  LocalMotion motion;
  if (static_cast<int>(around.size()) < kFewestNeighbours) return motion;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> rhs = Eigen::Matrix<double, 3, 2>::Zero();
  for (const MovedPoint& n : around) {
    const cv::Point2f d = n.reference - reference;
    const Eigen::Vector3d row(d.x, d.y, 1.0);
    normal += n.weight * row * row.transpose();
    rhs += n.weight * row * Eigen::RowVector2d(n.pixel.x, n.pixel.y);
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
  if (lu.rcond() < 1e-8) return motion;
  const Eigen::Matrix<double, 3, 2> solution = lu.solve(rhs);
  motion.linear = solution.topRows<2>().transpose();
  motion.place =
      cv::Point2f(static_cast<float>(solution(2, 0)), static_cast<float>(solution(2, 1)));
  double sum = 0.0;
  for (const MovedPoint& n : around) {
    const cv::Point2f d = n.reference - reference;
    const Eigen::Vector3d row(d.x, d.y, 1.0);
    sum += (solution.transpose() * row - Eigen::Vector2d(n.pixel.x, n.pixel.y)).squaredNorm();
  }
  motion.residual = std::sqrt(sum / static_cast<double>(around.size()));
  const Eigen::Vector2d scales = Eigen::JacobiSVD<Eigen::Matrix2d>(motion.linear).singularValues();
  motion.is_known =
      motion.linear.determinant() > 0.0 && scales[1] > kSmallestScale && scales[0] < kLargestScale;
  return motion;
}

void FindPatches(const cv::Mat& first, const cv::Mat& image, int window,
                 std::vector<Patch>* patches) {
  // All windows side by side in two pictures, so that one call finds all flows.
  const int tile = window + 2 * kPatchReach;
  const float centre = 0.5F * static_cast<float>(tile - 1);
  const int columns = std::max(1, static_cast<int>(std::sqrt(patches->size())));
  const int rows = static_cast<int>(patches->size()) / columns + 1;
  cv::Mat expected(rows * tile, columns * tile, CV_8U, cv::Scalar(0.0)), seen = expected.clone();
  const cv::Rect middle(kPatchReach, kPatchReach, window, window);
  std::vector<cv::Point2f> from;
  for (std::size_t k = 0; k < patches->size(); ++k) {
    const Patch& r = (*patches)[k];
    const cv::Rect box(static_cast<int>(k) % columns * tile, static_cast<int>(k) / columns * tile,
                       tile, tile);
    const Eigen::Matrix2d inverse = r.motion.linear.inverse();
    const Eigen::Vector2d shift =
        Eigen::Vector2d(r.reference.x, r.reference.y) - inverse * Eigen::Vector2d(centre, centre);
    const cv::Matx23d map(inverse(0, 0), inverse(0, 1), shift.x(),  //
                          inverse(1, 0), inverse(1, 1), shift.y());
    cv::Mat bent, patch;
    cv::warpAffine(first, bent, map, {tile, tile}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    cv::getRectSubPix(image, {tile, tile}, r.place, patch);
    // As light or as dark as what is seen: the cloth may have turned towards the light.
    const MeanAndSpread of_bent = Describe(bent(middle)), of_patch = Describe(patch(middle));
    const double gain = of_bent.spread > kLeastContrast ? of_patch.spread / of_bent.spread : 1.0;
    bent.convertTo(expected(box), CV_8U, gain, of_patch.mean - gain * of_bent.mean);
    patch.copyTo(seen(box));
    from.emplace_back(static_cast<float>(box.x) + centre, static_cast<float>(box.y) + centre);
  }
  if (from.empty()) return;
  std::vector<cv::Point2f> to = from;
  std::vector<uchar> found;
  const cv::Size size(window, window);
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.005);
  cv::calcOpticalFlowPyrLK(expected, seen, from, to, found, cv::noArray(), size, 0, criteria,
                           cv::OPTFLOW_USE_INITIAL_FLOW);
  for (std::size_t k = 0; k < from.size(); ++k) {
    Patch& r = (*patches)[k];
    if (found[k] == 0 || Length(to[k] - from[k]) > kPatchReach) continue;
    cv::Mat a, b;
    cv::getRectSubPix(expected, size, from[k], a);
    cv::getRectSubPix(seen, size, to[k], b);
    r.correlation = Correlation(a, b);
    r.place += to[k] - from[k];
  }
}

}  // namespace clothfit
