// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A small cloth in a small world, and what holds it: scenes that studies, benchmarks and tests
// share.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "autodiff_sim/step/simulation.h"

namespace clothfit {

struct ClothScene {
  ClothMesh mesh;
  World world;
  Eigen::VectorXd x;  // m, 3N, at time 0
  std::vector<SurfacePoint> handles;
  // Where the handles are (m, world) at a time (s); at time 0 where the cloth is.
  std::function<std::vector<Eigen::Vector3d>(double time)> path;

  // Holds the handles, if there are any, on their path; the path depends on no direction.
  Drive MakeDrive() const;
};

// N points (u, v) of the cloth (m), or its particles, in space: origin + u along + v across, 3N, m.
Eigen::VectorXd LayFlat(const std::vector<Eigen::Vector2d>& uv, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& along, const Eigen::Vector3d& across);
Eigen::VectorXd LayFlat(const ClothMesh& mesh, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& along, const Eigen::Vector3d& across);

// A square cloth of this side (m), n x n particles, that lies on the ground z = 0 within its
// contact distance while one corner is lifted and drawn inwards.
ClothScene LiftedCloth(int n, double side);

// Gives the simulation a supple, damped cloth in air, so that what is measured on it does not
// depend on clothfit's initial values. Terms that the simulation lacks are left out.
void UseSuppleCloth(Simulation* simulation);

// No handle at all.
Drive FreeDrive();

}  // namespace clothfit
