// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How the surroundings of a point have moved, and where they are found again.
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace clothfit {

inline double Length(const cv::Point2f& p) { return std::hypot(p.x, p.y); }

// pixel = linear (reference - reference of the point) + place, about a point.
struct LocalMotion {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  cv::Point2f place;      // px
  double residual = 0.0;  // px, root mean square of what it was fitted to
  // Whether there was enough to fit, and the surroundings can still be recognised: not edge-on, not
  // from behind.
  bool is_known = false;
};

// A point near the one that is asked for.
struct MovedPoint {
  cv::Point2f reference;  // px, in the first picture
  cv::Point2f pixel;      // px, now
  double weight = 1.0;
};

// By weighted least squares.
LocalMotion FitLocalMotion(const cv::Point2f& reference, const std::vector<MovedPoint>& around);

// A point's surroundings in the first picture, to be found in another one.
struct Patch {
  int point = 0;
  cv::Point2f reference;  // px, in the first picture
  LocalMotion motion;
  cv::Point2f place;          // px, from here; then where it was found
  double correlation = -1.0;  // there, of the window's pixels; -1: not found
};

// How far a patch may be found from where it is looked for, px.
inline constexpr int kPatchReach = 10;

// Bends each window (px, odd) of the first 8-bit grey picture as its surroundings have moved,
// lights it like what is seen, and finds it again by one level of Lucas and Kanade 1981.
void FindPatches(const cv::Mat& first, const cv::Mat& image, int window,
                 std::vector<Patch>* patches);

}  // namespace clothfit
