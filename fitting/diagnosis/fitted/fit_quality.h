// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How well a fit explains a recording.
#pragma once

#include "fitting/fit/fit.h"

namespace clothfit {

inline constexpr double kLargeResidual = 2.0;      // sigmas of residuals
inline constexpr double kUnusableResidual = 10.0;  // sigmas that no mesh makes up for

// Does a fit leave more than kLargeResidual?
bool HasLargeResidual(const Scene& scene, const FitConfig& config, const FitResult& fit);

// Does it leave so much (1.2 sigmas) that it may be in a local minimum?
bool MayBeLocalMinimum(const Scene& scene, const FitConfig& config, const FitResult& fit);

}  // namespace clothfit
