// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/autodiff_sim/contact/random_points.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

Vector3d RandomVector(std::mt19937* random) {
  std::normal_distribution<double> normal;
  const double x = normal(*random), y = normal(*random), z = normal(*random);
  return {x, y, z};
}

void PutOnALine(std::mt19937* random, FourPoints* x) {
  std::normal_distribution<double> normal;
  const Vector3d direction = RandomVector(random);
  for (int i = 1; i < 4; ++i) (*x)[i] = (*x)[0] + normal(*random) * direction;
}

}  // namespace

FourPoints RandomPoints(Position position, std::mt19937* random) {
  std::uniform_int_distribution<int> one_of_four(0, 3), small(-1, 2);
  FourPoints x;
  for (Vector3d& p : x) p = RandomVector(random);
  switch (position) {
    case Position::kGeneral:
      break;
    case Position::kCoplanar:
      for (Vector3d& p : x) p.z() = 0.25;
      break;
    case Position::kOnGrid:
      for (Vector3d& p : x) {
        for (double& value : p) value = small(*random);
      }
      break;
    case Position::kCollinear:
      PutOnALine(random, &x);
      break;
    case Position::kDuplicate:
      for (int i = 0; i < 2; ++i) x[one_of_four(*random)] = x[one_of_four(*random)];
      break;
    case Position::kParallel:
      x[3] = x[2] + small(*random) * (x[1] - x[0]);
      break;
    case Position::kNearlyParallel:
      x[3] = x[2] + (x[1] - x[0]) + 1e-9 * RandomVector(random);
      break;
    case Position::kSliver:
      PutOnALine(random, &x);
      for (int i = 0; i < 4; ++i) x[i] += 1e-9 * RandomVector(random);
      x[0] = RandomVector(random);
      break;
    case Position::kFarAway:
      for (Vector3d& p : x) p += Vector3d(800.0, -600.0, 0.0);
      break;
    case Position::kTiny:
      for (Vector3d& p : x) p *= 1e-6;
      break;
  }
  return x;
}

}  // namespace clothfit
