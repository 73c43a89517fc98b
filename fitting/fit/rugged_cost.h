// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of a fit that came to rest where its cost is rugged, and what may help there.
#pragma once

#include <string>
#include <vector>

namespace clothfit {

// promised: the share of the cost that a full step would take if the cost were as smooth as it
// seems; window (s): of the first windows, 0 of all frames at once.
std::string SayCostIsRugged(double promised, double window);

// That statement among those of a fit, see FitResult; empty where there is none.
std::string RuggedCostAmong(const std::vector<std::string>& statements);

}  // namespace clothfit
