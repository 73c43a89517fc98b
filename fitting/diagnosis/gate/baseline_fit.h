// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The baseline's own fit: a diagnosis explains its residuals, so that it may not end in a local
// minimum of the cost.
#pragma once

#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

inline constexpr int kFirstIterations = 5;  // enough to see which starts and models are worth more

// Of all frames: what cannot explain them need not come to its end.
inline constexpr int kBaselineIterations = 12;

// Particles along the longer side of the mesh that finds and orders, at most.
inline constexpr int kCoarseSide = 13;

// Fits a baseline to the frames that are not held out, with a start state free up to bilinear
// offsets, on the config's mesh or kCoarseSide particles a side, whichever is coarser. Its config
// is the baseline's but for mesh and start. Throws std::runtime_error where the simulation
// diverges.
FittedScene FitBaseline(const Recording& recording, const FitConfig& baseline,
                        const DiagnosisOptions& options);

}  // namespace clothfit
