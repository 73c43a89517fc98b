// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All that a fit depends on, as bytes: two fits with the same bytes come to the same result.
#pragma once

#include <string>

#include "fitting/fit/fit.h"

namespace clothfit {

// The scene with its recording and silhouettes, the config, where the fit goes on from (null: from
// its start) and the version of clothfit. Paths of files are left out: what they hold counts.
std::string FitInputsAsBytes(const Scene& scene, const FitConfig& config,
                             const FitCheckpoint* from);

}  // namespace clothfit
