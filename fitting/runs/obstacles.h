// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The obstacles of a scene as surfaces that a report can draw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fitting/runs/run_folder.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct ObstacleSurface {
  std::string name;
  std::vector<Eigen::VectorXd> positions;  // 3N, m, world: one a frame, or one for all
  std::vector<std::int32_t> triangles;     // three vertices each
};

// Round ones with flat faces; positions in every frame of the recording. Where `values`, those of
// MakeParameterTable(), say that they stand, or where the recording says.
std::vector<ObstacleSurface> ObstacleSurfaces(const Scene& scene,
                                              const Eigen::VectorXd& values = {});

// Writes report/obstacles.json and report/obstacle_N.npy (frames x vertices x 3, m) into the run;
// nothing where the scene has no obstacles.
void WriteObstacles(const Scene& scene, const Eigen::VectorXd& values, const RunFolder& run);

}  // namespace clothfit
