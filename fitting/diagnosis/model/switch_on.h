// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A candidate switched on and everything fitted again.
#pragma once

#include <optional>

#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

// The fitted baseline's own config, started from what it found, with a candidate's parameters and
// shapes free from their estimates; for an observation fault the recording is put right instead.
ModelStart SwitchOn(const FittedScene& fitted, const RankedCandidate& candidate,
                    const std::vector<Fault>& faults);

// Pa/m, of an obstacle into which the cloth sinks by a centimetre where nothing else carries its
// weight. What is softer is a field of force, and no obstacle.
double SoftestObstacle(const FittedScene& fitted);

// The scene of a fit with one candidate of a model that has others besides, begun from what the
// model found for that candidate and the material parameters.
ModelStart WithOnly(const FittedScene& before, const FittedScene& model,
                    const RankedCandidate& candidate);

// A fitted scene with one candidate of another model besides, as that has fitted it.
ModelStart WithEffectOf(const FittedScene& model, const RankedCandidate& candidate,
                        const FittedScene& fitted);

// From the material parameters that a config was given, where that is free, and with a candidate's
// amounts where a fit of its term begins: an estimate made at large residuals may be anything.
ModelStart FromNothing(const FitConfig& given, ModelStart start, const RankedCandidate& candidate);

// A candidate with less and more of its estimates besides, each as a start of its own: what is
// linear at nothing need not be so at the estimate. A gust's force grows with the square of it.
RankedCandidate AtShares(RankedCandidate candidate);

// The start of an effect that was just switched on, at the share of its linear estimate that comes
// nearest to the recording: all of it, or less.
ModelStart AtBestShare(const FittedScene& fitted, const ModelStart& start,
                       const RankedCandidate& candidate, const FitRunner& runner);

// The same of a candidate that was just switched on. Of physics by windows that grow, which do not
// ask for a good start; where there are none, from its best share and, where that leaves large
// residuals, from nothing, too: material parameters that had to stand for missing physics are no
// good start.
std::optional<FittedScene> FitFirst(const FittedScene& fitted, const ModelStart& start,
                                    const FitConfig& given, const RankedCandidate& candidate,
                                    int most_iterations, const FitRunner& runner);

}  // namespace clothfit
