// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes.h"

#include <cmath>

namespace clothfit {

TestScene SwingingCloth(int n, double side) {
  TestScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  const Eigen::Vector3d origin(0.0, 0.0, 0.3);
  scene.x = LayFlat(scene.mesh, origin, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  scene.handles = LocateOnCloth(scene.mesh, {{0.0, 0.0}, {side, 0.0}});
  scene.path = [origin, side](double time) {
    const double phase = 2.0 * M_PI * time;
    const Eigen::Vector3d sway(0.0, 0.05 * std::sin(phase), 0.02 * (1.0 - std::cos(phase)));
    const Eigen::Vector3d corner = origin + Eigen::Vector3d(side, 0.0, 0.0);
    return std::vector<Eigen::Vector3d>{origin + sway, corner + 0.8 * sway};
  };
  return scene;
}

}  // namespace clothfit
