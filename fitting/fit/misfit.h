// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How well fitted markers and tracks are met, against their stated noise.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "fitting/rollout/joint_scenes.h"

namespace clothfit {

// Residuals are counted in sigmas of the stated noise.
struct Misfit {
  int observed = 0;  // coordinates
  // Sum of the squared residuals over observed less free; 1 is expected of noise.
  double chi_square = 0.0;
  // Noise alone leaves more than this once in 740 fits (3 sigmas of a chi-square whose terms hang
  // together as the residuals do).
  double limit = 0.0;
  // So many residuals say as much as one, of what is smooth in time and over the cloth: 1 plus the
  // correlations of one residual with all others.
  double correlation = 1.0;
  // Root mean square of the discretisation error (fitting/fit/discretisation.h); how many times it
  // is surely in the residuals, by their estimate; and the chi-square of the residuals without so
  // much of it. Empty where they are not known.
  std::optional<double> discretisation, amplitude, without_discretisation;

  bool IsNoise() const { return chi_square <= limit; }
  // No more than noise and discretisation error.
  bool IsNoiseAndMesh() const {
    return std::min(chi_square, without_discretisation.value_or(chi_square)) <= limit;
  }
};

// A residual, and where on the cloth and when it was seen. What is of one series is one coordinate
// of one point, of one kind one coordinate of all points (of a camera).
struct SeenResidual {
  int frame = 0, series = 0, kind = 0;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();  // m
  double value = 0.0;
};

// Those of the fitted markers and tracks of frames 0 to the last, in the order of
// ObservationResiduals, of a scene without silhouettes.
std::vector<SeenResidual> SeenResiduals(const Scene& scene, const Eigen::VectorXd& residuals);

// The same of several recordings, one after the other, which have no series and no kind in common.
std::vector<SeenResidual> SeenResiduals(const JointScenes& scenes,
                                        const Eigen::VectorXd& residuals);

// num_free: entries that were fitted to the residuals. Correlations in time are those of series at
// each distance in frames, over the cloth those of kinds at each distance in spacings of the
// points, up to the first that is below twice its own standard error.
Misfit MeasureMisfit(const std::vector<SeenResidual>& seen, int num_free);

// What noise alone may leave of a chi-square of so many independent residuals, as Misfit::limit.
double ChiSquareLimit(double independent);

}  // namespace clothfit
