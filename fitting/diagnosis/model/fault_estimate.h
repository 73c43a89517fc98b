// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How large a fault of the observation is, once it is held to be the one.
#pragma once

#include <vector>

#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/model/screening.h"

namespace clothfit {

// The score test shares what is seen between a fault and everything else that could be off. In a
// model that puts the fault right nothing else is: its amounts are estimated again, beside what the
// model has free, and put right, and the model is fitted again (twice; Gauss-Newton by turns). What
// makes no better fit is not kept. Amounts and intervals of the candidate become those of the
// model; nothing happens to one of physics.
void EstimateFaultAgain(const std::vector<Fault>& faults, const FitRunner& runner,
                        FittedModel* model);

}  // namespace clothfit
