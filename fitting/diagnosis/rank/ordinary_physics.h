// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What every simulation has unless it is told otherwise (drag of still air, dampings, friction of
// the ground), where a baseline lacks it. A cloth without it may be so lively that no derivative of
// its motion tells anything; but such physics has values to begin with, and is tried with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

bool IsOrdinary(const RankedCandidate& candidate);

// Candidates of a ranking, by name, as one: its amounts are what a simulation begins with.
RankedCandidate Together(const Ranking& ranking, const std::vector<std::string>& names);

// All that is ordinary together, where it is more than one; by itself a piece of it may do nothing.
std::optional<RankedCandidate> AllOrdinary(const Ranking& ranking);

}  // namespace clothfit
