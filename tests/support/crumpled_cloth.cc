// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/crumpled_cloth.h"

#include <cmath>
#include <random>

namespace clothfit {

CrumpledCloth Crumple(unsigned seed, double height, int resolution) {
  CrumpledCloth cloth{MakeGrid({0.8, 0.6}, {resolution, resolution - 3}), {}};
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0.0, 2.0 * M_PI);
  cloth.x.resize(3 * cloth.mesh.num_particles());
  for (int i = 0; i < cloth.mesh.num_particles(); ++i) {
    cloth.x.segment<3>(3 * i) << cloth.mesh.uv[i], 0.0;
  }
  for (int wave = 0; wave < 4; ++wave) {
    Eigen::Vector2d direction;
    for (double& value : direction.reverse()) value = 5.0 * normal(random);
    Eigen::Vector3d amplitude;
    for (double& value : amplitude.reverse()) value = normal(random);
    amplitude.head<2>() *= 0.5;
    const double start = phase(random);
    for (int i = 0; i < cloth.mesh.num_particles(); ++i) {
      const double s = std::sin(direction.dot(cloth.mesh.uv[i]) + start);
      cloth.x.segment<3>(3 * i) += 0.5 * height * s * amplitude;
    }
  }
  return cloth;
}

}  // namespace clothfit
