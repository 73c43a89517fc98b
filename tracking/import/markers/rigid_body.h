// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The rigid bodies of a take: which markers are theirs, and how each moves.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tracking/import/markers/marker_take.h"

namespace clothfit {

// Moves the markers "BODY:..." of the bodies that are named out of the take's markers into its
// bodies, and of other prefixes where three or more keep their distances. A body that has markers
// among those `expected` has these.
void TakeOutBodies(const std::set<std::string>& names, const std::vector<MarkerPath>& expected,
                   MarkerTake* take);

struct RigidMotion {
  std::vector<Eigen::Vector3d> reference;  // m, world: of each marker while the body rests
  // The world's frame then to the world's now: one at rest (the identity), or one a frame. Where
  // fewer than three markers are seen, the last one before, or else the first, holds.
  std::vector<Eigen::Isometry3d> path = {Eigen::Isometry3d::Identity()};
  int num_lost = 0;  // frames that such a pose was taken for
};

// How the body moves: by least squares (Umeyama 1991). A body at rest rests at its markers' mean
// places; a moving one at those of the first frame that has them all, or most. Throws InputError
// where that has fewer than three markers.
RigidMotion FindRigidMotion(const RigidBody& body);

}  // namespace clothfit
