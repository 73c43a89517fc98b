// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Nudging: every marker, every track's ray and every point of a cloud, this at what is closest to
// it when a frame begins, pulls at the cloth, so that it follows what was observed whatever else is
// wrong (Abarbanel, Creveling, Farsian and Kostuk 2009, Dynamical state and parameter estimation).
#pragma once

#include <optional>

#include "fitting/config/config.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// Are there markers or tracks, of which it is known where on the cloth they are?
bool HasPoints(const Scene& scene);

// Of critical, of what pulls. In fits enough to end the ringing: more of it hides how the cloth
// moves by itself, and fits that were critically damped ended at costs up to 1.7 times those. What
// is to be as near to the recorded cloth as can be is damped critically.
inline constexpr double kFittingDamping = 0.3, kScoringDamping = 1.0;

// At a share of 1 the cloth follows within 1 / kNudgingRate.
inline constexpr double kNudgingRate = 40.0;  // 1/s

// The config of a fit or a simulation in which all of these that are fitted of a scene pull at the
// cloth, at the rate sqrt(share) kNudgingRate. damping: of critical. Empty
// where there is nothing to pull.
std::optional<FitConfig> NudgedConfig(FitConfig config, const Scene& scene, double share,
                                      double damping = kFittingDamping);

}  // namespace clothfit
