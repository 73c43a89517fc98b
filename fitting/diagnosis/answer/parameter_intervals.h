// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How certain the parameters of a model are.
#pragma once

#include <string>
#include <vector>

#include "fitting/config/config.h"
#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/fit/fit.h"

namespace clothfit {

// The fitted ones of these names (term.parameter), in the table's order, with 90 % intervals: those
// of the fit within its bounds.
std::vector<EffectParameter> EstimatesOf(const FitResult& fit, const FitConfig& config,
                                         const std::vector<std::string>& names);

// Makes both ends of every interval no number: of estimates by a search that was stopped.
void ForgetIntervals(std::vector<EffectParameter>* parameters);

}  // namespace clothfit
