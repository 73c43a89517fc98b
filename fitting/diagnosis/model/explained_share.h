// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The share of the excess cost that a model explains.
#pragma once

namespace clothfit {

// Share explained: (before - after) / max(before - null, explainable), clamped to 0..1; 0 where the
// denominator is not positive. All are costs: of the fit without the model and with it, the mean
// over the null, and the most that absent terms can explain (Ranking::explainable, halved).
double ShareExplained(double before, double after, double null, double explainable);

// The same of costs of fits whose noise leaves `noise`, and discretisation errors of `mesh` sigmas
// at most mesh^2 times as much besides. Where that might be all there is, a name has to take half
// of what is beyond noise, or it explains nothing: no other mesh is that much like an effect.
double ShareBeyondMesh(double before, double after, double noise, double mesh);

// Shares explained: of what is named, and of what is the best there is.
inline constexpr double kMostOfIt = 0.9, kHalfOfIt = 0.5;

}  // namespace clothfit
