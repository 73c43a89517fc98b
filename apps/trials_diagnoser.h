// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What `clothfit trials` measures.
#pragma once

#include "fitting/diagnosis/trial_run.h"

namespace clothfit {

// Empty in a build without a diagnosis: then plans and effects can be looked at, but not scored.
Diagnoser DiagnoserToMeasure();

}  // namespace clothfit
