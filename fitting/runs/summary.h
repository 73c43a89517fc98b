// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How a fit went, as JSON: what summary.json is made of. What is not known is null.
#pragma once

#include <nlohmann/json.hpp>

#include "fitting/fit/fit.h"

namespace clothfit {

// All of it, of the fit of one recording.
nlohmann::ordered_json SummaryAsJson(const Scene& scene, const FitConfig& config,
                                     const FitResult& result);
// What the whole of a fit of several recordings has: no errors, and no frames.
nlohmann::ordered_json JointSummaryAsJson(const FitResult& result);

}  // namespace clothfit
