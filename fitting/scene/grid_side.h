// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Coarser and finer grids of the same shape.
#pragma once

#include <array>

namespace clothfit {

// Particles along it.
int LongerSide(const std::array<int, 2>& grid);

// A grid of the same shape with this many particles along its longer side.
std::array<int, 2> GridWithSide(const std::array<int, 2>& grid, int longest_side);

// Particles along a side of the next finer mesh: spacings become shorter by kFiner.
inline constexpr double kFiner = 1.5;
int FinerSide(int side);

}  // namespace clothfit
