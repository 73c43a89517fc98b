// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How well one open-loop simulation explains a scene's observations.
#pragma once

#include "fitting/fit/fit.h"

namespace clothfit {

// Simulates all frames at theta and measures every observation, held-out ones among them.
Evaluation EvaluateScene(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                         const Eigen::VectorXd& theta);

}  // namespace clothfit
