// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Follows points of the cloth through the pictures of one camera: Hasler 2007, sec. 4.1.
//
// From frame to frame by the pyramidal Lucas-Kanade method (OpenCV). That drifts, and it goes on
// when the point has long been hidden. So every point is compared with its surroundings in the
// first frame, bent the way its neighbours on the cloth have moved: where both agree, the place is
// corrected to fit the first frame; where they do not, the point is lost. A lost point is looked
// for where its neighbours say it should be, and is taken up again when it looks as it did.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "tracking/camera/camera.h"
#include "tracking/features/cloth_coordinates.h"
#include "tracking/features/patch_search.h"

namespace clothfit {

struct PointTrackerOptions {
  int max_points = 500;
  double min_distance = 6.0;      // px between points in the first frame
  double min_contrast = 0.01;     // least corner strength, as a share of the largest
  int window = 15;                // px, side of what is compared
  int levels = 3;                 // of the pyramid, above the picture itself
  bool check_backward = true;     // forward and backward have to lead to the same place
  double max_backward = 0.7;      // px
  bool check_move = true;         // no point may leap
  double max_move = 30.0;         // px from one frame to the next
  bool check_neighbours = true;   // a point has to move about as its neighbours on the cloth do
  double max_deviation = 4.0;     // px, and a tenth of the neighbours' own deformation
  bool check_reference = true;    // a point has to look as in the first frame
  double min_correlation = 0.75;  // of its surroundings with those in the first frame
  double max_drift = 2.5;         // px that fitting to the first frame may correct
  bool redetect = true;           // look for lost points again
  double redetect_correlation = 0.9;
};

struct TrackedPoint {
  int id = 0;
  Eigen::Vector2d uv;     // m, on the cloth
  Eigen::Vector2d pixel;  // px
};

class PointTracker {
 public:
  explicit PointTracker(const PointTrackerOptions& options = {}) : options_(options) {}

  // Chooses points in the first frame (8-bit BGR picture, mask of the cloth) and finds their place
  // on the cloth.
  std::vector<TrackedPoint> Start(const cv::Mat& image, const cv::Mat& mask, const Camera& camera,
                                  const ClothCoordinates& cloth);

  // The points that are seen in the next frame. An empty mask stands for cloth everywhere; an empty
  // image for a frame that is not there.
  std::vector<TrackedPoint> Advance(const cv::Mat& image, const cv::Mat& mask);

  // How often points were lost, by why, and found again: "backward", "move", "mask", "neighbours",
  // "reference", "found again".
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  struct Point {
    Eigen::Vector2d uv;
    cv::Point2f reference;        // px, in the first frame
    cv::Point2f pixel;            // px, where it was seen last
    std::vector<int> neighbours;  // the nearest on the cloth, nearest first
    bool is_live = true;
  };
  void Lose(Point* point, const std::string& why);
  void FindNeighbours();
  LocalMotion MotionAround(const Point& point) const;
  void Flow(const cv::Mat& image);
  void CheckMask(const cv::Mat& mask);
  void CheckNeighbours();
  void CheckReference(const cv::Mat& image);
  void Redetect(const cv::Mat& image, const cv::Mat& mask);
  std::vector<TrackedPoint> Live() const;

  PointTrackerOptions options_;
  cv::Mat first_, last_;  // 8-bit grey
  std::vector<Point> points_;
  std::map<std::string, int> counts_;
};

}  // namespace clothfit
