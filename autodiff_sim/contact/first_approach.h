// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// When a vertex first comes to a triangle, or an edge to an edge, all their points moving on
// straight lines.
#pragma once

#include <optional>

#include "autodiff_sim/contact/closest_points.h"
#include "autodiff_sim/contact/conservative_advancement.h"

namespace clothfit {

// Points at x0 (m) at time 0 and at x1 at time 1. The first time in [0, until] at which they have
// met, see Advance(); none where they do not. It is never late, nor is a meeting missed.
std::optional<double> FirstVertexTriangleApproach(const FourPoints& x0, const FourPoints& x1,
                                                  const Approach& approach, double until = 1.0);
std::optional<double> FirstEdgeEdgeApproach(const FourPoints& x0, const FourPoints& x1,
                                            const Approach& approach, double until = 1.0);

}  // namespace clothfit
