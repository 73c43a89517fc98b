// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/explained_share.h"

#include <algorithm>

namespace clothfit {

double ShareExplained(double before, double after, double null, double explainable) {
  const double excess = std::max(before - null, explainable);
  return excess > 0.0 ? std::clamp((before - after) / excess, 0.0, 1.0) : 0.0;
}

double ShareBeyondMesh(double before, double after, double noise, double mesh) {
  const double of_mesh = noise * (1.0 + mesh * mesh);
  if (before > of_mesh) return ShareExplained(before, after, of_mesh, 0.0);
  const double share = ShareExplained(before, after, noise, 0.0);
  return share >= kHalfOfIt ? share : 0.0;
}

}  // namespace clothfit
