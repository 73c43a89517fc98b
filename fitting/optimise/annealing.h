// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Simulated annealing for functions of continuous variables (Corana, Marchesi, Martini and Ridella
// 1987, ACM TOMS 13(3)), as Bhat et al. 2003 and, at first, Hasler et al. 2007 used.
#pragma once

#include "fitting/optimise/optimiser.h"

namespace clothfit {

// One chain: coordinates are moved in turn by a uniform random amount, whose range is adapted so
// that about half of the moves are taken; uphill moves with the probability exp(-rise /
// temperature). The first temperature is the mean rise of the first moves, each next one is 0.85 of
// it; every temperature begins at the best point so far. Ends when all ranges are below the
// tolerance, or the chain ends four temperatures in a row within 1e-6 of the best value. The same
// for the same seed; uses one worker.
Minimum Anneal(const Objective& objective, const OptimiserOptions& options);

}  // namespace clothfit
