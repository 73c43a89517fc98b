// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of a fit, and what they would be on a finer mesh with half the step.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "fitting/rollout/joint_scenes.h"

namespace clothfit {

// Of what is observed in a recording, on one mesh.
struct MeshRows {
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
};

// A recording's markers and tracks alone, or its outlines, as it is given and on the finer mesh.
struct SceneOnMeshes {
  Scene scene;
  FitConfig config;
  double weight = 1.0;  // of the squares of its rows
  std::optional<MeshRows> own, finer;
};

// Outlines are all that is observed.
bool SeesOutlinesAlone(const Scene& scene);

// The rows of the points of measured outlines, each outline's first row and their number, among
// those of ObservationResiduals of the fitted frames. Particles' own rows, as many as the mesh has
// particles, are left out.
std::vector<std::pair<Eigen::Index, Eigen::Index>> OutlineRows(const Scene& scene);

// Of the fitted frames at theta; of outlines alone the rows of OutlineRows. Empty where they cannot
// be simulated.
std::optional<MeshRows> EvaluateRows(const Scene& scene, const FitConfig& config,
                                     const Eigen::VectorXd& theta, bool derivatives);

// The same on both meshes, side by side, the given one with derivatives.
void EvaluateBoth(const JointVector& free, const Eigen::VectorXd& theta,
                  std::vector<SceneOnMeshes>* scenes);

// The rows of all, one recording after the other, with the columns of all. Empty where one has
// none.
std::optional<MeshRows> Stack(const JointVector& free, const std::vector<SceneOnMeshes>& scenes,
                              std::optional<MeshRows> SceneOnMeshes::*rows);

}  // namespace clothfit
