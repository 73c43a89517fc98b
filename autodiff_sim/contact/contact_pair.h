// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A pair of the cloth's features as the contact force needs it.
#pragma once

#include <array>

#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

struct ContactPair {
  PairKind kind;             // kVertexTriangle or kEdgeEdge
  std::array<int, 4> nodes;  // particles, in the order of PairVertices()
  double area;               // m^2 of cloth that the pair stands for
  // m^4, squared length of the edges' cross product below which their force fades, see
  // terms/self_contact.h; 0 for a vertex and a triangle.
  double parallel;
};

}  // namespace clothfit
