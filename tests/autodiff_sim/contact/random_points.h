// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Four points at chance, in general position and in every degenerate one.
#pragma once

#include <array>
#include <random>

#include "autodiff_sim/contact/closest_points.h"

namespace clothfit {

enum class Position {
  kGeneral,
  kCoplanar,
  kOnGrid,  // small integers, where ties, parallels and common points are frequent
  kCollinear,
  kDuplicate,       // two of the points are the same, or more
  kParallel,        // the edges 0-1 and 2-3 are
  kNearlyParallel,  // to 1e-9
  kSliver,          // collinear to 1e-9
  kFarAway,         // 1000 times as far from the origin as large
  kTiny,            // 1e-6 of the others' size
};
constexpr std::array<Position, 10> kPositions = {
    Position::kGeneral,   Position::kCoplanar, Position::kOnGrid,         Position::kCollinear,
    Position::kDuplicate, Position::kParallel, Position::kNearlyParallel, Position::kSliver,
    Position::kFarAway,   Position::kTiny};

// About 1 m across (kTiny: 1e-6).
FourPoints RandomPoints(Position position, std::mt19937* random);

}  // namespace clothfit
