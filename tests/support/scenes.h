// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Small cloths in small worlds, shared by tests and benchmarks. All are at rest at time 0.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/cloth_mesh.h"
#include "autodiff_sim/simulation.h"

namespace clothfit {

struct TestScene {
  ClothMesh mesh;
  World world;
  Eigen::VectorXd x;  // m, 3N, at time 0
  std::vector<SurfacePoint> handles;
  // Where the handles are (m, world) at a time (s); at time 0 where the cloth is.
  std::function<std::vector<Eigen::Vector3d>(double time)> path;

  // Holds the handles on their path; the path depends on no direction.
  Drive MakeDrive() const;
};

// The cloth's rest shape in space: origin + u along + v across, m.
Eigen::VectorXd LayFlat(const ClothMesh& mesh, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& along, const Eigen::Vector3d& across);

// A square cloth of this side (m), n x n particles, horizontal, held at the two corners of its edge
// v = 0, which swing to and fro by 5 cm; the rest falls and swings through.
TestScene SwingingCloth(int n, double side);

// A square cloth of this side (m), n x n particles, that lies on the ground z = 0 within its
// contact distance while one corner is lifted and drawn inwards.
TestScene LiftedCloth(int n, double side);

// Gives the simulation a supple, damped cloth in air, so that what is measured on it does not
// depend on clothfit's initial values. Terms that the simulation lacks are left out.
void UseSuppleCloth(Simulation* simulation);

// No handle at all.
Drive FreeDrive();

}  // namespace clothfit
