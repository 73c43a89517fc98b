// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How much less a row of residuals says than as many independent ones.
#pragma once

#include <vector>

namespace clothfit {

// Integrated autocorrelation time, in samples, of series around zero: 1 + 2 sum of the correlations
// at lags 1, 2, ... up to the first below 0.05, each pooled over all series; at least 1. So many
// samples in a row say as much as one (Sokal 1997, sec. 3).
double CorrelationTime(const std::vector<std::vector<double>>& series);

}  // namespace clothfit
