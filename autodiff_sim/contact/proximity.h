// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which features are close, at one time.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// A pair and its closest points.
struct Contact {
  FeaturePair pair;
  // Of its four vertices, in the order of PairVertices(). The sum of weight times place is the
  // offset (m) between the closest points, to the vertex from the triangle or to the first edge
  // from the second. Those of the first sum to 1, those of the second to -1.
  std::array<double, 4> weights;
  double distance;       // m, the length of the offset
  double cross_squared;  // m^4, of two edges: see EdgeEdgeClosest, 0 where parallel; else 0
};

// The closest points of one pair.
Contact MeasureContact(const FeaturePair& pair, const FourPoints& points);

// All pairs of features of a surface at x (3N, m) that are closer than `distance` (m, above 0),
// those with a vertex in common excepted; sorted. Where the mesh is as fine as the distance these
// are neighbours too, such as the two far corners across an edge's hinge.
template <int Planes>
std::vector<Contact> FindProximity(const Eigen::VectorXd& x, double distance,
                                   CollisionSurface<Planes>* surface);

// The same between a cloth at x (3N, m) and an obstacle at y (3M, m).
template <int Planes>
std::vector<Contact> FindProximity(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                   double distance, CollisionSurface<Planes>* cloth,
                                   CollisionSurface<Planes>* obstacle);

}  // namespace clothfit
