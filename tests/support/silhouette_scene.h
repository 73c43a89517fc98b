// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The small recording with three cameras that saw nothing but its silhouettes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "fitting/config/config.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct SilhouetteScene {
  FitConfig config;  // starts off the truth
  Scene scene;
  std::vector<std::pair<std::string, double>> truth;     // what the start is off by
  std::vector<Eigen::VectorXd> true_x;                   // m, by frame
  std::vector<std::vector<Eigen::Vector3d>> true_paths;  // m, by handle and frame

  // m, root mean square over all particles and frames, for a free vector of this config.
  double SurfaceError(const Eigen::VectorXd& theta) const;
};

// 7 x 7 particles, 15 frames. `hidden`: nobody says where the two handles went.
SilhouetteScene MakeSilhouetteScene(bool hidden = false, int frames = 15);

}  // namespace clothfit
