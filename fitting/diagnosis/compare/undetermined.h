// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Amounts of an effect that a recording does not determine: the components of a wind along a cloth
// that hangs in it, the mass of a hem at an edge that has none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/model/screening.h"

namespace clothfit {

// Of each term with several amounts that are 0 where it is off: those whose 90 % interval holds 0,
// but for the one that is known best for its size.
std::vector<std::string> Undetermined(const std::vector<EffectParameter>& parameters);

// A fitted model without them, fitted again: what does not show adds its own uncertainty to all
// else. Empty where there are none, the fit fails, or the model explains (of a fit without it at
// `cost_before`) less than nine tenths as much without them or predicts the held-out frames worse
// by more than a twentieth.
std::optional<FittedModel> WithoutUndetermined(const FittedModel& model, double cost_before,
                                               const std::vector<EffectParameter>& parameters,
                                               const FitRunner& runner);

// Sets the values to those of a model, 0 where it does not have them; intervals stay as they are,
// but hold the values.
void TakeValues(const FitConfig& values, std::vector<EffectParameter>* parameters);

}  // namespace clothfit
