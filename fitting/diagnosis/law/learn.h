// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// None of the above: a short law for what no term of the catalogue explains, out of the features of
// the terms law_* (autodiff_sim/terms/law.h).
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

struct LearnedFit {
  FittedScene scene;               // with the law on
  std::vector<std::string> terms;  // "law_air"
  std::vector<std::string> names;  // of the coefficients that are kept
};

// Scores the families of features as candidates are scored, fits the best two (FitFirst; at large
// residuals from the material parameters of the config `given`, too), takes out of the better one
// the coefficients whose own 95 % intervals hold 0, and fits again until none does; then looks for
// a second family beside it, unless the first leaves no more than the null. Nothing where no family
// passes the null.
std::optional<LearnedFit> LearnLaw(const FittedScene& baseline, const FitConfig& given,
                                   const Ranking& ranking, const DiagnosisOptions& options);

// The law as formulas with units and the range of places it was learned in: "air velocity w_x =
// 0.4 m/s - 3.1 1/s (y - 0.1 m)".
std::string LawFormula(const LearnedFit& law, const Extent& extent);

}  // namespace clothfit
