// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A first guess of where an unseen point of the cloth went.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/scene/scene.h"

namespace clothfit {

struct PathPoint {
  double time;               // s
  Eigen::Vector3d position;  // m, world
};

// Where the point (u, v) (m) of the cloth lies on the thin-plate spline through the markers of each
// fitted frame that has at least four, not all on one line. Good to a few centimetres: a start for
// the fit, not an observation.
std::vector<PathPoint> GuessPath(const Scene& scene, const Eigen::Vector2d& uv);

}  // namespace clothfit
