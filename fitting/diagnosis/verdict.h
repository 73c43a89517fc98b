// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis comes to.
#pragma once

#include "fitting/diagnosis/diagnosis.h"

namespace clothfit {

// The share that a model takes of what a fit before it leaves above its null, costs all; where mesh
// and step may make more than that, of what can be explained at all: what stands out of the null by
// its pattern does so below its sum, too. Nothing where nothing can.
double ShareExplained(double before, double after, double null, double explainable);

// Of a diagnosis that has run to its end. explained: the share that what was named takes of what
// the baseline leaves above its null; is_above_floor: what it leaves is well above what mesh and
// step make.
Verdict VerdictOf(const Diagnosis& diagnosis, double explained, bool is_above_floor);

}  // namespace clothfit
