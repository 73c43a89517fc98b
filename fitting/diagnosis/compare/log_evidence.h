// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How much more a recording speaks for one model than for another.
#pragma once

namespace clothfit {

// Residuals that hang together, and that are larger than their sigmas by what no model has.
struct ResidualScale {
  double rows = 1.0;         // observed coordinates
  double correlation = 1.0;  // so many of them say as much as one, at least 1
  double chi_square = 1.0;   // of the better model; below 1 it counts as 1
};

// Natural logarithm of the Bayes factor of a model against the same without its effect, by
// Schwarz's approximation (1978, The Annals of Statistics 6, equation 1; Kass and Raftery 1995,
// section 4.1.3):
//
//   (before - after) / (chi_square correlation) - unknowns / 2 ln(rows / correlation)
//
// before, after: costs, half the sums of squares in sigmas. What the better model leaves beyond
// noise scales all residuals, as it does the intervals: a difference that is small against what
// both leave says little.
double LogEvidence(double before, double after, double unknowns, const ResidualScale& scale);

// ln 20: odds from which Kass and Raftery call evidence strong; an error in 20 where either of two
// models is as likely beforehand.
inline constexpr double kStrongEvidence = 2.9957;

}  // namespace clothfit
