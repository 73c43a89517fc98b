// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The discretisation error of a fit, by mesh and step, and how far its markers and tracks are met.
#pragma once

#include <optional>
#include <vector>

#include "fitting/fit/misfit.h"
#include "fitting/fit/uncertainty.h"
#include "fitting/rollout/joint_scenes.h"

namespace clothfit {

struct PointFit {
  Misfit misfit;
  ModelErrors errors;
};

// Of all recordings together, and of each by itself.
struct JointPointFit {
  PointFit all;
  std::vector<PointFit> of_each;
};

// Of the fitted markers and tracks at theta, without the discretisation error: one simulation.
// Empty as below.
std::optional<Misfit> MisfitOfPoints(const Scene& scene, const FitConfig& config,
                                     const Eigen::VectorXd& theta);

// Of the fitted markers and tracks at theta; empty where there are none, or they cannot be
// simulated.
//
// The discretisation error is estimated from a simulation with half the step and from one on the
// finer mesh (FinerSide) besides, as if both errors were of second order (Richardson): the
// converged simulation lies 4/3 times as far off as that with half the step, and from there 1 / (1
// - 1 / kFiner^2) times as far as the finer mesh. Where a mesh is no grid or a simulation fails it
// is not known. Recordings that are simulated alike err alike: there is one amount of all their
// errors.
//
// Three simulations of each, one of them with derivatives, side by side.
std::optional<JointPointFit> MeasurePoints(const JointScenes& scenes, const Eigen::VectorXd& theta);

// Of outlines where they are all that is observed, what their intervals have to hold beyond noise,
// by the same estimate; empty where something else is observed, or they cannot be simulated.
std::optional<ModelErrors> MeasureOutlines(const JointScenes& scenes, const Eigen::VectorXd& theta);

// So many residuals of outlines say as much as one: of neighbours along an outline by
// CorrelationTime, in time those of 0.2 s. `outlines`: residuals of one each.
double OutlineCorrelation(const std::vector<std::vector<double>>& outlines, double frame_rate);

}  // namespace clothfit
