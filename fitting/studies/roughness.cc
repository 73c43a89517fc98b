// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/roughness.h"

#include <cmath>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

Eigen::Vector3d Normal(const Eigen::VectorXd& x, int a, int b, int c) {
  const Eigen::Vector3d at = x.segment<3>(3 * a);
  return (x.segment<3>(3 * b) - at).cross(x.segment<3>(3 * c) - at);
}

}  // namespace

double Roughness(const ClothMesh& mesh, const Eigen::VectorXd& x) {
  double sum = 0.0;
  const std::vector<Hinge> hinges = BuildTopology(mesh).hinges;
  for (const Hinge& hinge : hinges) {
    const auto& [one, other, from, to] = hinge.nodes;
    const Eigen::Vector3d a = Normal(x, one, from, to), b = Normal(x, other, to, from);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    sum += angle * angle;
  }
  return hinges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(hinges.size()));
}

}  // namespace clothfit
