// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a point lies from where its neighbours in time and on the cloth lead one to expect it.
// What moves smoothly cancels, whatever the motion; noise and gross errors stay.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace clothfit {

// A point of the cloth at one frame; of tracks z is 0.
struct ObservedPoint {
  int frame = 0;
  int id = 0;                // the same id is the same point of the cloth
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m (world), or px
};

// Of each point the nearest 8 on the cloth that are seen at the same frame, nearest first.
std::vector<std::vector<int>> NearestOfFrame(const std::vector<ObservedPoint>& points);

class Unexplained {
 public:
  // `points` must outlive this object. Of one kind: markers, or the tracks of one camera.
  explicit Unexplained(const std::vector<ObservedPoint>& points);

  // The length, m or px, of a point's second difference in time less the median of the same over
  // the nearest points on the cloth; scaled so that noise has one size whatever the gaps are. 0
  // where too little is seen around a point.
  double Size(int point) const { return sizes_[point]; }
  // What is usual around a point: the median size over its neighbours at the same frame, or over
  // all points, whichever is larger; before anything was left out.
  double Usual(int point) const { return usual_[point]; }
  // Takes a point out, and tells which others' sizes change by that.
  std::vector<int> LeaveOut(int point);

 private:
  Eigen::Vector3d InTime(int point) const;
  double Measure(int point) const;

  const std::vector<ObservedPoint>& points_;
  std::vector<int> before_, after_;      // of the same id; -1 where there is none
  std::vector<Eigen::Vector3d> shared_;  // median over the neighbours
  std::vector<double> sizes_, usual_;
};

}  // namespace clothfit
