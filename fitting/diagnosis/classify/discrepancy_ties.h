// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// To what a missing force is tied: the marginal likelihood of families of forces that have fewer
// dimensions than any force at all.
#pragma once

#include <vector>

#include "fitting/diagnosis/classify/discrepancy_class.h"

namespace clothfit {

// The cloth at each knot of the map: a frame (columns normal, warp, weft) and a place (m) a node.
struct KnotPose {
  std::vector<Eigen::Matrix3d> frames;
  std::vector<Eigen::Vector3d> places;
};
std::vector<KnotPose> KnotPoses(const Scene& scene, const MissingForce& missing);
// The frame of the recording at a knot, the last where the knot is beyond it.
int FrameOfKnot(const MissingForce& missing, int knot);

// Best first; the one of any force at all among them.
std::vector<TriedTie> FindTies(const Scene& scene, const MissingForce& missing,
                               const ForcePatch& patch);

}  // namespace clothfit
