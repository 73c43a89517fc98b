// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of the ranked candidates are worth a fit.
#pragma once

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

// Of well-made recordings, one sigma: no fault is looked for below so many.
inline constexpr double kWellMade = 3.0;

// Gives every candidate its false discovery rate over all of them (Benjamini and Hochberg 1995),
// its parameters with their intervals, and short-lists it or says why not. A fault is held to no
// share of the residual, or where there are outlines alone, whose residuals hang together along
// them, to a hundredth; physics that stands out as much and explains more of the same residuals is
// short-listed beside it. has_points: there are markers or tracks, not outlines alone, of which no
// physics is short-listed where the residual may be discretisation error.
void ShortList(bool has_points, const DiagnosisOptions& options, Ranking* ranking);

}  // namespace clothfit
