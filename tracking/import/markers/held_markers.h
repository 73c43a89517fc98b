// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which markers of a take something holds.
//
// Cloth pulls and does not push. A marker of acceleration a that nothing holds is carried by the
// cloth around it, so its specific force a - g is a sum of pulls towards other markers. What no
// such sum can give is its support: something else than the cloth carries it. It is nearly 1 g at a
// corner in a hand, and small wherever cloth hangs.
#pragma once

#include <vector>

#include "tracking/import/markers/marker_take.h"

namespace clothfit {

// Seconds from the start over which support is averaged.
inline constexpr double kSupportTime = 0.5;

// From this support on, in g, a marker is held. Of 39 takes (docs/importing.md) held ones have at
// least 0.94 and others at most 0.37, but for one marker of 0.61.
inline constexpr double kHeldSupport = 0.75;

// The support of each marker (in g, 0 to 1 but for strong accelerations), averaged over the first
// kSupportTime of the take; zero where it is not seen. Gravity is along -z.
std::vector<double> SupportAtStart(const MarkerTake& take);

// The markers with a support of kHeldSupport or more, in their order, that are above the lowest
// marker at first by a tenth of how far apart markers are: others may lie on something, as all of a
// cloth that is level may.
std::vector<size_t> FindHeldMarkers(const std::vector<double>& support, const MarkerTake& take);

}  // namespace clothfit
