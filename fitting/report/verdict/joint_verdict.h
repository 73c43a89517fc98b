// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How well one cloth explains several recordings, in words that the fit's numbers support.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

// Good: converged, with residuals in all recordings that noise and discretisation error may leave.
// Partial: better than the start in all. Else poor.
PageVerdict JudgeJointFit(const nlohmann::ordered_json& summary);

// sqrt(3) sigmas of a coordinate for the distance of a marker, sqrt(2) for that of a track: what
// noise alone leaves. `entry`: of the summary's recordings; empty where none is stated.
std::optional<double> NoiseOf(const nlohmann::ordered_json& entry, const std::string& kind);

}  // namespace clothfit
