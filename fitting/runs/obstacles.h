// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The obstacles of a scene and of a model as surfaces that can be drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fitting/scene/scene.h"

namespace clothfit {

struct ObstacleSurface {
  std::string name;
  std::vector<Eigen::VectorXd> positions;  // 3N, m, world: one a frame, or one for all
  std::vector<std::int32_t> triangles;     // three vertices each
  // Cut off around the cloth, since it has no end; the triangles face outwards then.
  bool is_cut = false;
};

// Those of the recording, then those that the model's terms stand for (terms/obstacle.h) where they
// push. Round ones with flat faces; those of the recording in every frame of it, and where
// `values`, those of MakeParameterTable(), say that they stand. Planes and tables have no end: as
// much of them as lies below, above or beside the cloth in the positions `cloth` (3N, m).
std::vector<ObstacleSurface> ObstacleSurfaces(const Scene& scene, const Eigen::VectorXd& values,
                                              const std::vector<Eigen::VectorXd>& cloth);

}  // namespace clothfit
