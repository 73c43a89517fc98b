// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How much less a fit's residuals say than as many independent ones: what a model does not have
// pushes the same way for many frames.
#pragma once

#include <vector>

#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

// Integrated autocorrelation time, in samples, of series around zero: 1 + 2 sum of the correlations
// at lags 1, 2, ... up to the first below 0.05, each pooled over all series; at least 1. So many
// samples in a row say as much as one (Sokal 1997, sec. 3).
double CorrelationTime(const std::vector<std::vector<double>>& series);

// The same of a fit's residuals of markers and tracks over the frames that it was fitted to, in
// frames; 1 where there are neither or the fit cannot be simulated.
double ResidualCorrelationTime(const FittedScene& fitted);

}  // namespace clothfit
