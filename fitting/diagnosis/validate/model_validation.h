// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a model predicts frames better that its fit has not seen.
#pragma once

#include <cstdint>
#include <optional>

#include "fitting/diagnosis/rank/ranking.h"
#include "fitting/diagnosis/validate/held_out_validation.h"

namespace clothfit {

// The source of observations whose fault is put right, see MeasureAgainstOthers; empty of physics.
std::optional<int> FaultySource(const RankedCandidate& candidate, const Ranking& ranking);

// A model against the fit without what it has. `source`: a camera is put right where it looks, by
// its own tracks, where there are markers, too. by_mesh: D_h, the discretisation error of a
// prediction (m or px, root mean square), which an improvement has to exceed; a source has none.
HeldOutValidation ValidateOnHeldOut(const FittedScene& model, const FittedScene& before,
                                    std::optional<int> source, double by_mesh, std::uint64_t seed);

}  // namespace clothfit
