// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/grid_side.h"

#include <algorithm>
#include <cmath>

namespace clothfit {

int LongerSide(const std::array<int, 2>& grid) { return std::max(grid[0], grid[1]); }

int FinerSide(int side) { return 1 + static_cast<int>(std::lround(kFiner * (side - 1))); }

std::array<int, 2> GridWithSide(const std::array<int, 2>& grid, int longest_side) {
  const int longer = LongerSide(grid);
  std::array<int, 2> other = grid;
  for (int& n : other) {
    const double share = static_cast<double>(longest_side - 1) / (longer - 1);
    n = 1 + std::max(1, static_cast<int>(std::lround(share * (n - 1))));
  }
  return other;
}

}  // namespace clothfit
