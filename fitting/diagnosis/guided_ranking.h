// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Candidates scored along a guided motion. A cloth that swings by itself is soon somewhere else
// than the recorded one, by its mesh alone, and linear effects around that motion say little: on 13
// and 25 particles a side their cosine falls to 0 within a second. While all that was seen pulls at
// it (nudging), it stays near, the same cosines are 0.6 to 0.9, and what is missing shows as what
// has to be pulled for.
#pragma once

#include "fitting/diagnosis/fit_runner.h"
#include "fitting/diagnosis/ranking.h"

namespace clothfit {

// Fits the model of `fitted` guided, from the fabric of the config that a diagnosis was told, ranks
// around that, and adds to the ranking where the first four that stand out there would begin
// (RankedCandidate::guided_starts) and their p-values. Does nothing where nothing can guide
// or the guided fit fails.
void RankGuided(const FittedScene& fitted, const FitConfig& told, const DiagnosisOptions& options,
                const FitRunner& runner, Ranking* ranking);

}  // namespace clothfit
