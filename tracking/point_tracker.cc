// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/point_tracker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace clothfit {
namespace {

constexpr std::size_t kNeighbours = 12;  // of which a motion is read off
constexpr int kFewestNeighbours = 5;
// A surface that is seen this much smaller or larger than in the first frame does not look alike.
constexpr double kSmallestScale = 0.25, kLargestScale = 4.0;
constexpr int kMargin = 10;  // px around the window, so that the flow finds its gradients
constexpr double kLeastContrast = 2.0;  // grey levels
constexpr double kLongestReach = 8.0;   // px that a lost point may be off its neighbours' guess

cv::Mat Grey(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

double Length(const cv::Point2f& p) { return std::hypot(p.x, p.y); }

bool IsInside(const cv::Size& size, const cv::Point2f& p, float border) {
  return p.x >= border && p.y >= border && p.x <= static_cast<float>(size.width - 1) - border &&
         p.y <= static_cast<float>(size.height - 1) - border;
}

bool IsSet(const cv::Mat& mask, const cv::Point2f& p) {
  return mask.empty() ||
         (IsInside(mask.size(), p, 0.0F) && mask.at<uchar>(cvRound(p.y), cvRound(p.x)) != 0);
}

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

std::vector<TrackedPoint> PointTracker::Start(const cv::Mat& image, const cv::Mat& mask,
                                              const Camera& camera, const ClothCoordinates& cloth) {
  first_ = last_ = Grey(image);
  points_.clear();
  counts_.clear();
  cv::Mat inside = mask;
  if (!mask.empty()) cv::erode(mask, inside, cv::Mat(), {-1, -1}, options_.window / 3);
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(first_, corners, options_.max_points, options_.min_contrast,
                          options_.min_distance, inside);
  for (const cv::Point2f& corner : corners) {
    if (!IsInside(first_.size(), corner, static_cast<float>(options_.window))) continue;
    const std::optional<Eigen::Vector2d> uv = cloth.At(camera, {corner.x, corner.y});
    if (uv) points_.push_back({*uv, corner, corner, {}, true});
  }
  FindNeighbours();
  return Live();
}

std::vector<TrackedPoint> PointTracker::Advance(const cv::Mat& image, const cv::Mat& mask) {
  if (image.empty() || points_.empty()) return {};
  const cv::Mat grey = Grey(image);
  Flow(grey);
  CheckMask(mask);
  if (options_.check_neighbours) CheckNeighbours();
  if (options_.check_reference) CheckReference(grey);
  if (options_.redetect) Redetect(grey, mask);
  last_ = grey;
  return Live();
}

std::vector<TrackedPoint> PointTracker::Live() const {
  std::vector<TrackedPoint> live;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    if (p.is_live) live.push_back({static_cast<int>(i), p.uv, {p.pixel.x, p.pixel.y}});
  }
  return live;
}

void PointTracker::Lose(Point* point, const std::string& why) {
  point->is_live = false;
  ++counts_[why];
}

void PointTracker::FindNeighbours() {
  std::vector<int> order(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::iota(order.begin(), order.end(), 0);
    const auto nearer = [&](int a, int b) {
      return (points_[a].uv - points_[i].uv).squaredNorm() <
             (points_[b].uv - points_[i].uv).squaredNorm();
    };
    // Twice as many as are needed: some will be lost. The first is the point itself.
    const std::size_t count = std::min(2 * kNeighbours + 1, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end(), nearer);
    points_[i].neighbours.clear();
    for (std::size_t k = 0; k < count; ++k) {
      if (order[k] != static_cast<int>(i)) points_[i].neighbours.push_back(order[k]);
    }
  }
}

// An affine map through the live neighbours, nearer ones first, by least squares.
PointTracker::LocalMotion PointTracker::MotionAround(const Point& point) const {
  LocalMotion motion;
  std::vector<const Point*> used;
  for (const int n : point.neighbours) {
    if (points_[n].is_live && used.size() < kNeighbours) used.push_back(&points_[n]);
  }
  if (static_cast<int>(used.size()) < kFewestNeighbours) return motion;
  const double reach = (used.back()->uv - point.uv).norm();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> rhs = Eigen::Matrix<double, 3, 2>::Zero();
  for (const Point* n : used) {
    const double weight = 1.0 / (0.05 + (n->uv - point.uv).squaredNorm() / (reach * reach));
    const cv::Point2f d = n->reference - point.reference;
    const Eigen::Vector3d row(d.x, d.y, 1.0);
    normal += weight * row * row.transpose();
    rhs += weight * row * Eigen::RowVector2d(n->pixel.x, n->pixel.y);
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
  if (lu.rcond() < 1e-8) return motion;
  const Eigen::Matrix<double, 3, 2> solution = lu.solve(rhs);
  motion.linear = solution.topRows<2>().transpose();
  motion.place =
      cv::Point2f(static_cast<float>(solution(2, 0)), static_cast<float>(solution(2, 1)));
  double sum = 0.0;
  for (const Point* n : used) {
    const cv::Point2f d = n->reference - point.reference;
    const Eigen::Vector2d moved =
        motion.linear * Eigen::Vector2d(d.x, d.y) + Eigen::Vector2d(motion.place.x, motion.place.y);
    sum += (moved - Eigen::Vector2d(n->pixel.x, n->pixel.y)).squaredNorm();
  }
  motion.residual = std::sqrt(sum / static_cast<double>(used.size()));
  // Seen edge-on or from behind, the surroundings do not look as they did.
  const Eigen::Vector2d scales = Eigen::JacobiSVD<Eigen::Matrix2d>(motion.linear).singularValues();
  motion.is_known =
      motion.linear.determinant() > 0.0 && scales[1] > kSmallestScale && scales[0] < kLargestScale;
  return motion;
}

void PointTracker::Flow(const cv::Mat& image) {
  std::vector<int> indices;
  std::vector<cv::Point2f> from;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].is_live) continue;
    indices.push_back(static_cast<int>(i));
    from.push_back(points_[i].pixel);
  }
  if (from.empty()) return;
  const cv::Size window(options_.window, options_.window);
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  std::vector<cv::Point2f> to, back;
  std::vector<uchar> found, found_back;
  cv::calcOpticalFlowPyrLK(last_, image, from, to, found, cv::noArray(), window, options_.levels,
                           criteria);
  cv::calcOpticalFlowPyrLK(image, last_, to, back, found_back, cv::noArray(), window,
                           options_.levels, criteria);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    Point& point = points_[indices[k]];
    if (found[k] == 0 || !IsInside(image.size(), to[k], 1.0F)) {
      Lose(&point, "picture");
    } else if (options_.check_backward &&
               (found_back[k] == 0 || Length(back[k] - from[k]) > options_.max_backward)) {
      Lose(&point, "backward");
    } else if (options_.check_move && Length(to[k] - from[k]) > options_.max_move) {
      Lose(&point, "move");
    } else {
      point.pixel = to[k];
    }
  }
}

void PointTracker::CheckMask(const cv::Mat& mask) {
  for (Point& point : points_) {
    if (point.is_live && !IsSet(mask, point.pixel)) Lose(&point, "mask");
  }
}

void PointTracker::CheckNeighbours() {
  std::vector<Point*> deviating;
  for (Point& point : points_) {
    if (!point.is_live) continue;
    const LocalMotion motion = MotionAround(point);
    if (!motion.is_known ||
        Length(point.pixel - motion.place) > options_.max_deviation + 2.0 * motion.residual) {
      deviating.push_back(&point);
    }
  }
  for (Point* point : deviating) Lose(point, "neighbours");
}

void PointTracker::Register(const cv::Mat& image, std::vector<Registration>* registrations) const {
  // All windows side by side in two pictures, so that one call finds all flows.
  const int tile = options_.window + 2 * kMargin;
  const float centre = 0.5F * static_cast<float>(tile - 1);
  const int columns = std::max(1, static_cast<int>(std::sqrt(registrations->size())));
  const int rows = static_cast<int>(registrations->size()) / columns + 1;
  cv::Mat expected(rows * tile, columns * tile, CV_8U, cv::Scalar(0.0)), seen = expected.clone();
  const cv::Rect middle(kMargin, kMargin, options_.window, options_.window);
  std::vector<cv::Point2f> from;
  for (std::size_t k = 0; k < registrations->size(); ++k) {
    const Registration& r = (*registrations)[k];
    const cv::Rect box(static_cast<int>(k) % columns * tile, static_cast<int>(k) / columns * tile,
                       tile, tile);
    const Eigen::Matrix2d inverse = r.motion.linear.inverse();
    const cv::Point2f& reference = points_[r.point].reference;
    const Eigen::Vector2d shift =
        Eigen::Vector2d(reference.x, reference.y) - inverse * Eigen::Vector2d(centre, centre);
    const cv::Matx23d map(inverse(0, 0), inverse(0, 1), shift.x(),  //
                          inverse(1, 0), inverse(1, 1), shift.y());
    cv::Mat bent, patch;
    cv::warpAffine(first_, bent, map, {tile, tile}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
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
  const cv::Size window(options_.window, options_.window);
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.005);
  cv::calcOpticalFlowPyrLK(expected, seen, from, to, found, cv::noArray(), window, 0, criteria,
                           cv::OPTFLOW_USE_INITIAL_FLOW);
  for (std::size_t k = 0; k < from.size(); ++k) {
    Registration& r = (*registrations)[k];
    if (found[k] == 0 || Length(to[k] - from[k]) > kMargin) continue;
    cv::Mat a, b;
    cv::getRectSubPix(expected, window, from[k], a);
    cv::getRectSubPix(seen, window, to[k], b);
    r.correlation = Correlation(a, b);
    r.place += to[k] - from[k];
  }
}

void PointTracker::CheckReference(const cv::Mat& image) {
  std::vector<Registration> registrations;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].is_live) continue;
    const LocalMotion motion = MotionAround(points_[i]);
    if (motion.is_known) {
      registrations.push_back({static_cast<int>(i), motion, points_[i].pixel, -1.0});
    } else {
      Lose(&points_[i], "neighbours");
    }
  }
  Register(image, &registrations);
  for (const Registration& r : registrations) {
    Point& point = points_[r.point];
    if (r.correlation < options_.min_correlation ||
        Length(r.place - point.pixel) > options_.max_drift) {
      Lose(&point, "reference");
    } else {
      point.pixel = r.place;
    }
  }
}

void PointTracker::Redetect(const cv::Mat& image, const cv::Mat& mask) {
  std::vector<Registration> registrations;
  const float border = static_cast<float>(options_.window);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].is_live) continue;
    const LocalMotion motion = MotionAround(points_[i]);
    if (motion.is_known && IsInside(image.size(), motion.place, border) &&
        IsSet(mask, motion.place)) {
      registrations.push_back({static_cast<int>(i), motion, motion.place, -1.0});
    }
  }
  Register(image, &registrations);
  for (const Registration& r : registrations) {
    if (r.correlation < options_.redetect_correlation ||
        Length(r.place - r.motion.place) >
            std::min(kLongestReach, options_.max_deviation + 2.0 * r.motion.residual) ||
        !IsSet(mask, r.place)) {
      continue;
    }
    Point& point = points_[r.point];
    point.pixel = r.place;
    point.is_live = true;
    ++counts_["found again"];
  }
}

}  // namespace clothfit
