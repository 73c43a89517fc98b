// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/terms/diagonal_thread.h"

#include <algorithm>
#include <cmath>

namespace clothfit {

std::vector<ThreadPiece> DiagonalThreadPieces(const ClothMesh& mesh) {
  std::vector<ThreadPiece> pieces;
  if (!mesh.is_grid()) return pieces;
  const int cells = std::max(mesh.grid[0], mesh.grid[1]) - 1;
  const auto particle = [&](int k) {
    const double share = static_cast<double>(k) / cells;
    const int i = static_cast<int>(std::lround(share * (mesh.grid[0] - 1)));
    const int j = static_cast<int>(std::lround(share * (mesh.grid[1] - 1)));
    return i + j * mesh.grid[0];
  };
  for (int k = 0; k < cells; ++k) {
    const int a = particle(k), b = particle(k + 1);
    pieces.push_back({{a, b}, (mesh.uv[b] - mesh.uv[a]).norm()});
  }
  return pieces;
}

}  // namespace clothfit
