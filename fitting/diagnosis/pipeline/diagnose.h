// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What physics a recording shows that the simulation lacks: where and when the two differ, what
// class of effect that is, which one, how much of it, what else it could be, and whether frames
// that no fit has seen are predicted better with it. docs/diagnosis.md tells the method.
#pragma once

#include "fitting/config/config.h"
#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/fitted/options.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// Fits the baseline and goes through the eight steps. Throws InputError where the recording cannot
// be fitted at all.
Diagnosis Diagnose(const Recording& recording, const FitConfig& baseline,
                   const DiagnosisOptions& options = {});

}  // namespace clothfit
