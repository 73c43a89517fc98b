// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/outliers/unexplained.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace clothfit {
namespace {

constexpr int kNeighbours = 8;
constexpr int kEnoughToAverage = 3;  // neighbours

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<std::vector<int>> NearestOfFrame(const std::vector<ObservedPoint>& points) {
  std::map<int, std::vector<int>> by_frame;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) by_frame[points[i].frame].push_back(i);
  std::vector<std::vector<int>> nearest(points.size());
  std::vector<std::pair<double, int>> near;
  for (const auto& [frame, seen] : by_frame) {
    for (const int i : seen) {
      near.clear();
      for (const int j : seen) {
        if (j != i) near.push_back({(points[i].uv - points[j].uv).squaredNorm(), j});
      }
      const auto count =
          static_cast<std::ptrdiff_t>(std::min<std::size_t>(kNeighbours, near.size()));
      std::partial_sort(near.begin(), near.begin() + count, near.end());
      for (std::ptrdiff_t k = 0; k < count; ++k)
        nearest[i].push_back(near[static_cast<std::size_t>(k)].second);
    }
  }
  return nearest;
}

Unexplained::Unexplained(const std::vector<ObservedPoint>& points)
    : points_(points),
      before_(points.size(), -1),
      after_(points.size(), -1),
      shared_(points.size(), Eigen::Vector3d::Zero()),
      sizes_(points.size(), 0.0),
      usual_(points.size(), 0.0) {
  const int count = static_cast<int>(points.size());
  std::map<int, std::vector<int>> by_id;
  for (int i = 0; i < count; ++i) by_id[points[i].id].push_back(i);
  for (auto& [id, series] : by_id) {
    std::stable_sort(series.begin(), series.end(),
                     [&](int a, int b) { return points[a].frame < points[b].frame; });
    for (std::size_t k = 1; k < series.size(); ++k) {
      before_[series[k]] = series[k - 1];
      after_[series[k - 1]] = series[k];
    }
  }
  const std::vector<std::vector<int>> neighbours = NearestOfFrame(points);
  std::vector<Eigen::Vector3d> in_time;
  for (int i = 0; i < count; ++i) in_time.push_back(InTime(i));
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      std::vector<double> values;
      for (const int j : neighbours[i]) {
        if (std::isfinite(in_time[j][k])) values.push_back(in_time[j][k]);
      }
      shared_[i][k] = static_cast<int>(values.size()) >= kEnoughToAverage
                          ? Median(std::move(values))
                          : std::numeric_limits<double>::quiet_NaN();
    }
  }
  for (int i = 0; i < count; ++i) sizes_[i] = Measure(i);
  std::vector<double> known;
  for (const double size : sizes_) {
    if (size > 0.0) known.push_back(size);
  }
  const double median = Median(std::move(known));
  for (int i = 0; i < count; ++i) {
    std::vector<double> around;
    for (const int j : neighbours[i]) around.push_back(sizes_[j]);
    usual_[i] = std::max(median, Median(std::move(around)));
  }
}

// Off the line through two others of the same id: before and after, or two of one side.
Eigen::Vector3d Unexplained::InTime(int point) const {
  int a = before_[point], b = after_[point];
  if (a < 0 && b >= 0) a = after_[b];
  if (b < 0 && a >= 0) b = before_[a];
  constexpr int kLongest = 4;  // frames between the two
  const auto unknown = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  if (a < 0 || b < 0) return unknown;
  const double from = points_[a].frame - points_[point].frame;
  const double to = points_[b].frame - points_[point].frame;
  if (from == to || std::max(std::abs(from), std::abs(to)) > kLongest) return unknown;
  const double weight_a = to / (to - from), weight_b = -from / (to - from);
  const Eigen::Vector3d off =
      points_[point].position - weight_a * points_[a].position - weight_b * points_[b].position;
  const double noise = std::sqrt((1.0 + weight_a * weight_a + weight_b * weight_b) / 1.5);
  const double acceleration = std::abs(from * to);  // against 1 of equal steps
  // An end that is off weighs more than the point beside it, which it makes half as much off.
  constexpr double kEnd = 0.75;
  const bool is_end = from * to > 0.0;
  return off / (std::max(noise, acceleration) * (is_end ? kEnd : 1.0));
}

double Unexplained::Measure(int point) const {
  const double size = (InTime(point) - shared_[point]).norm();
  return std::isfinite(size) ? size : 0.0;
}

std::vector<int> Unexplained::LeaveOut(int point) {
  const int a = before_[point], b = after_[point];
  if (a >= 0) after_[a] = b;
  if (b >= 0) before_[b] = a;
  before_[point] = after_[point] = -1;
  sizes_[point] = 0.0;
  std::vector<int> changed;
  for (const int i : {a >= 0 ? before_[a] : -1, a, b, b >= 0 ? after_[b] : -1}) {
    if (i < 0) continue;
    sizes_[i] = Measure(i);
    changed.push_back(i);
  }
  return changed;
}

}  // namespace clothfit
