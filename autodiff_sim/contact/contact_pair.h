// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A pair of the cloth's features as the contact force needs it.
#pragma once

#include <array>

#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// The share of |e|^2 |f|^2 at rest below which edges count as parallel: Li et al. 2020, sec. 4.4.1.
constexpr double kParallelShare = 1e-3;
// A motion ends where a gap is this share of what it was, or of the thickness if that is smaller.
constexpr double kGapSlack = 0.2, kGapTolerance = 0.1;

struct ContactPair {
  PairKind kind;             // kVertexTriangle or kEdgeEdge
  std::array<int, 4> nodes;  // particles, in the order of PairVertices()
  double area;               // m^2 of cloth that the pair stands for
  // m^4, squared length of the edges' cross product below which their force fades, see
  // terms/self_contact.h; 0 for a vertex and a triangle.
  double parallel;
};

}  // namespace clothfit
