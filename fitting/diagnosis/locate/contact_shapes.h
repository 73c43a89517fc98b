// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an obstacle that no one told of would stand. What a contact does to a cloth points along
// the obstacle's outward normal, at a place that is fixed in the world: the places that a missing
// force pushed from sweep out its surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

// A piece of cloth at one time, and the force on it.
struct Push {
  Eigen::Vector3d at;     // m, world
  Eigen::Vector3d force;  // N/m^2, world
};

// Those of at least a third of the largest, of the mesh that the force was estimated on.
std::vector<Push> StrongestPushes(const ClothMesh& mesh, const MissingForce& missing);

struct PlaneFit {
  Eigen::Vector3d normal;  // outward
  double height;           // m, of the plane along it
};
// Through the pushes' places, square to their mean.
PlaneFit FitPlane(const std::vector<Push>& pushes);

struct SphereFit {
  Eigen::Vector3d middle;  // m
  double radius;           // m
};
// The point that the lines along the forces come nearest to; empty where they are parallel.
std::optional<SphereFit> FitSphere(const std::vector<Push>& pushes);

struct CapsuleFit {
  Eigen::Vector3d end_1, end_2;  // m, of its axis
  double radius;                 // m
};
// Along the direction that the forces have least of; its axis is what lines along them come nearest
// to, and its ends are beyond all places by half of their extent. Empty where the forces are
// parallel.
std::optional<CapsuleFit> FitCapsule(const std::vector<Push>& pushes);

// The terms obstacle_* that these pushes may come from, each with the shape that fits them.
struct ContactStart {
  std::string term;
  Probe probe;
};
std::vector<ContactStart> ContactStarts(const std::vector<Push>& pushes,
                                        const Eigen::Vector3d& gravity);

}  // namespace clothfit
