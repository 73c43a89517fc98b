// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A model fitted to forecasts: windows of a recording, each simulated from the state of a nudged
// motion. A cloth that swings by itself is soon somewhere else than the recorded one, by its mesh
// alone, and a whole simulation says little about what is missing then; forecasts of half a second
// do.
#pragma once

#include <limits>

#include "fitting/fit/fit.h"

namespace clothfit {

// s. Of half a second are forecasts that models are compared by: at a quarter what is missing has
// hardly begun to show, and beyond a second the recorded motion is lost (docs/diagnosis.md).
inline constexpr double kLeadTime = 0.54;

// How many lengths of windows (WindowLengths) are no longer than that; the first of them always is
// one. 0 where there are no windows.
int NumForecastLengths(const Scene& scene, const FitConfig& config);

inline constexpr int kAllLengths = std::numeric_limits<int>::max();

// Fits windows of those lengths, the first most_lengths of them. The result has theta, parameters,
// the cost and the misfit of the longest windows (cost_after with the priors), and neither errors
// nor intervals; it has failed where they cannot be simulated. `from`: where it begins, and with
// how many lengths done.
FitResult FitForecasts(const Scene& scene, const FitConfig& config,
                       const FitCallbacks& callbacks = {}, const FitCheckpoint* from = nullptr,
                       int most_lengths = kAllLengths);

}  // namespace clothfit
