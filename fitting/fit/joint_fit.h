// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Several recordings of one cloth in one fit.
#pragma once

#include <vector>

#include "fitting/fit/fit.h"
#include "fitting/rollout/joint_scenes.h"

namespace clothfit {

// Throws InputError where the configs do not agree on what the recordings share (IsShared), or ask
// for another search than that by Levenberg-Marquardt.
void CheckJoint(const std::vector<NamedScene>& scenes);

// Fits shared parameters to all recordings and each one's own entries to itself: as RunFit of one
// problem. FitResult::recordings has what is to be said of each, in their order; of the whole there
// are no errors (before, after), and in its estimates each shared parameter is there once and what
// is of a recording is called NAME/... One recording is fitted as RunFit fits it, to the bit.
FitResult RunJointFit(const std::vector<NamedScene>& scenes, const FitCallbacks& callbacks = {},
                      const FitCheckpoint* resume = nullptr, bool tells_misfit = false);

// What that says of a recording that it was not fitted to: simulated with what it found of the
// shared parameters, and with the start of all else.
FitResult PredictRecording(const Scene& scene, const FitConfig& config, const FitResult& fit);

}  // namespace clothfit
