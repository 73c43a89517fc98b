// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Candidates scored along a nudged motion. A cloth that swings by itself is soon somewhere else
// than the recorded one, by its mesh alone, and linear effects around that motion say little: on 13
// and 25 particles a side their cosine falls to 0 within a second. While all that was seen pulls at
// it (nudging), it stays near, the same cosines are 0.6 to 0.9, and what is missing shows as what
// has to be pulled for.
#pragma once

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

// Ranks around a fit that is nudged to what was seen (FitNudged with kScoringDamping), and adds to
// the ranking of the same model where the first four that stand out there would begin
// (RankedCandidate::nudged_starts) and their p-values.
void RankNudged(const FittedScene& held, const DiagnosisOptions& options, Ranking* ranking);

}  // namespace clothfit
