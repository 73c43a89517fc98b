// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a cloth is by what was seen of it in one frame.
#pragma once

#include <Eigen/Core>

#include "fitting/scene/scene.h"

namespace clothfit {

// A simulated cloth (x: 3N, m) moved to where the markers and tracks of a frame have it: least
// squares over displacements of 5 x 5 nodes, bilinear in between, each with a sigma of 20 mm. What
// is pulled to what was seen rings and lags or leads by some milliseconds, in which a camera's
// clock would be lost; this has no memory. x itself where nothing was seen.
Eigen::VectorXd MovedToWhatWasSeen(const Scene& scene, int frame, const Eigen::VectorXd& x);

}  // namespace clothfit
