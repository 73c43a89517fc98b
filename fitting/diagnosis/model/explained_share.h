// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of what is missing a model explains.
#pragma once

namespace clothfit {

// The share that a model takes of what a fit before it leaves above its null, costs all; where mesh
// and step may make more than that, of what can be explained at all: what stands out of the null by
// its pattern does so below its sum, too. Nothing where nothing can.
double ShareExplained(double before, double after, double null, double explainable);

inline constexpr double kMostOfIt = 0.9;  // of what is missing

}  // namespace clothfit
