// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/point_tracker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace clothfit {
namespace {

constexpr std::size_t kNeighbours = 12;  // of which a motion is read off
constexpr double kLongestReach = 8.0;    // px that a lost point may be off its neighbours' guess

cv::Mat Grey(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool IsInPicture(const cv::Size& size, const cv::Point2f& p, float border) {
  return p.x >= border && p.y >= border && p.x <= static_cast<float>(size.width - 1) - border &&
         p.y <= static_cast<float>(size.height - 1) - border;
}

bool IsSet(const cv::Mat& mask, const cv::Point2f& p) {
  return mask.empty() ||
         (IsInPicture(mask.size(), p, 0.0F) && mask.at<uchar>(cvRound(p.y), cvRound(p.x)) != 0);
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
    if (!IsInPicture(first_.size(), corner, static_cast<float>(options_.window))) continue;
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

LocalMotion PointTracker::MotionAround(const Point& point) const {
  std::vector<const Point*> used;
  for (const int n : point.neighbours) {
    if (points_[n].is_live && used.size() < kNeighbours) used.push_back(&points_[n]);
  }
  if (used.empty()) return {};
  // Nearer ones count more.
  const double reach = std::max(1e-9, (used.back()->uv - point.uv).squaredNorm());
  std::vector<MovedPoint> around;
  for (const Point* n : used) {
    const double weight = 1.0 / (0.05 + (n->uv - point.uv).squaredNorm() / reach);
    around.push_back({n->reference, n->pixel, weight});
  }
  return FitLocalMotion(point.reference, around);
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
    if (found[k] == 0 || !IsInPicture(image.size(), to[k], 1.0F)) {
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

void PointTracker::CheckReference(const cv::Mat& image) {
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].is_live) continue;
    const LocalMotion motion = MotionAround(points_[i]);
    if (motion.is_known) {
      patches.push_back(
          {static_cast<int>(i), points_[i].reference, motion, points_[i].pixel, -1.0});
    } else {
      Lose(&points_[i], "neighbours");
    }
  }
  FindPatches(first_, image, options_.window, &patches);
  for (const Patch& r : patches) {
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
  std::vector<Patch> patches;
  const float border = static_cast<float>(options_.window);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].is_live) continue;
    const LocalMotion motion = MotionAround(points_[i]);
    if (motion.is_known && IsInPicture(image.size(), motion.place, border) &&
        IsSet(mask, motion.place)) {
      patches.push_back({static_cast<int>(i), points_[i].reference, motion, motion.place, -1.0});
    }
  }
  FindPatches(first_, image, options_.window, &patches);
  for (const Patch& r : patches) {
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
