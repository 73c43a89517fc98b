// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of a fit, and what they would be with half the step, and on a finer mesh besides.
#pragma once

#include <optional>
#include <vector>

#include "fitting/rollout/joint_scenes.h"

namespace clothfit {

// Of what is observed in a recording, on one mesh.
struct MeshRows {
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
};

// A recording's markers and tracks alone, or its outlines: as it is given, on its mesh with half
// the step, and on the finer mesh with half the step.
struct SceneOnMeshes {
  Scene scene;
  FitConfig config;
  double weight = 1.0;  // of the squares of its rows
  std::optional<MeshRows> own = {}, half_step = {}, finer = {};
};

// Outlines are all that is observed.
bool SeesOutlinesAlone(const Scene& scene);

// The rows of the points of one measured outline, among those of ObservationResiduals of the fitted
// frames. Particles' own rows, as many as the mesh has particles, are left out.
struct RowsOfOutline {
  Eigen::Index first = 0, count = 0;
  int frame = 0;
};
std::vector<RowsOfOutline> OutlineRows(const Scene& scene);

// Of the fitted frames at theta; of outlines alone the rows of OutlineRows. Empty where they cannot
// be simulated.
std::optional<MeshRows> EvaluateRows(const Scene& scene, const FitConfig& config,
                                     const Eigen::VectorXd& theta, bool derivatives);

// The rows of all of SceneOnMeshes, side by side, the given ones with derivatives.
void EvaluateOnMeshes(const JointVector& free, const Eigen::VectorXd& theta,
                      std::vector<SceneOnMeshes>* scenes);

// The rows of all, one recording after the other, with the columns of all. Empty where one has
// none.
std::optional<MeshRows> Stack(const JointVector& free, const std::vector<SceneOnMeshes>& scenes,
                              std::optional<MeshRows> SceneOnMeshes::*rows);

}  // namespace clothfit
