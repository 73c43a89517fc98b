// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Default terms: ordinary physics (Role::kOrdinary) that a baseline lacks, such as drag of still
// air, dampings, friction of the ground. A cloth without it may be so lively that no derivative of
// its motion tells anything; but such physics has initial values, and is tried with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

bool IsDefaultTerm(const RankedCandidate& candidate);

// Candidates of a ranking, by name, as one: its amounts are what a simulation begins with.
RankedCandidate Together(const Ranking& ranking, const std::vector<std::string>& names);

// All default terms together, where there are several; one alone may do nothing.
std::optional<RankedCandidate> AllDefaultTerms(const Ranking& ranking);

}  // namespace clothfit
