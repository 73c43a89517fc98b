// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a simulated frame leaves unexplained: markers and clouds in metres, tracks and outlines in
// pixels, over their sigmas.
#pragma once

#include <memory>
#include <vector>

#include <ceres/loss_function.h>

#include "fitting/optimise/row_major_matrix.h"
#include "fitting/residuals/cloud_residuals.h"
#include "fitting/residuals/point_residual.h"
#include "fitting/residuals/soft_silhouette.h"
#include "fitting/scene/scene.h"

namespace clothfit {

class ObservationResiduals {
 public:
  ObservationResiduals(const Scene& scene, const FitConfig& config);

  const Scene& scene() const { return scene_; }

  // Residuals of the fitted observations of one frame: 3 a marker, 2 a track, those of clouds and
  // of a soft silhouette.
  int Count(int frame) const;
  // Those of all frames in first..last.
  int Count(int first, int last) const;
  // The observed coordinates of these frames: as Count, but of a silhouette the outline's points
  // only, and of a cloud its own. Particles say nothing as long as they lie within.
  int NumObserved(int first, int last) const;

  // Writes the frame's residuals from `row` on and, where `jacobian` is given, their derivatives
  // along the sensitivity's directions. A robust loss rho acts on each observation: its residuals
  // are scaled by sqrt(rho(s) / s), s their squared norm, so that the sum of squares is the sum of
  // rho. Returns false where a tracked point lies behind its camera, or SoftSilhouette has none.
  bool Evaluate(int frame, const State& state, const Sensitivity* sensitivity, int row,
                Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) const;
  // The same with derivatives by the points that move them.
  bool EvaluateAtPoints(int frame, const State& state, std::vector<PointResidual>* residuals) const;

 private:
  template <int kRows>
  void Store(const Eigen::Matrix<double, kRows, 1>& r,
             const Eigen::Matrix<double, kRows, 3>& by_point, const SurfacePoint& point,
             double weight, PointResidual* residuals) const;

  // Writes the frame's and returns the place behind them.
  PointResidual* EvaluateClouds(int frame, const State& state, PointResidual* residuals) const;
  bool EvaluateSilhouettes(int frame, const State& state, PointResidual* residuals) const;

  const Scene& scene_;
  double silhouette_weight_, other_weight_;  // of residuals: sqrt(alpha), sqrt(beta)
  std::unique_ptr<ceres::LossFunction> loss_;
  std::vector<std::unique_ptr<SoftSilhouette>> soft_;  // by camera; null where nothing is fitted
  std::unique_ptr<CloudResiduals> clouds_;             // null where there are none
  // By frame, one more than there are frames.
  std::vector<std::size_t> first_marker_, first_track_, first_cloud_, first_silhouette_;
};

}  // namespace clothfit
