// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis comes to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/validate/held_out_validation.h"

namespace clothfit {

// The share that a named effect has to explain: kMostOfIt, or half where the answer leaves more
// than kUnusableResidual.
double MostOfIt(const Diagnosis& diagnosis);

// Does a validated law take the place of the named effects? If the share that it explains is larger
// by 0.1 or by half of the share that they do not explain; or if it is smaller by 0.1 at most and
// its error on the same held-out frames at most 0.8 of theirs. names: null for none.
bool TakesPlace(const HeldOutValidation& law, double explained_by_law,
                const HeldOutValidation* names, double explained_by_names);

// Is the gain of an effect on a finer mesh at least 0.3 of that on the mesh on which it was found?
bool StandsOnFinerMesh(double gain, double gain_on_finer);

struct ChoiceRules {
  double cost_before;  // of the fit without any of the models
  double least_share;  // that a model has to explain
  bool validate;       // must a model that is kept be validated?
};

// Of the models from `first` on, the best first: the first with share explained >= least_share, at
// least half of the largest gain and a validation (where `validate`), which is kept unless the fit
// without its effect catches up; else the first model, not kept, if its share is >= least_share: it
// may have found a better local minimum.
struct Choice {
  std::size_t model;  // of all
  bool is_kept;
};
std::optional<Choice> ChooseModel(const std::vector<Model>& models, std::size_t first,
                                  const ChoiceRules& rules);

// A cost of at most this much of another is far less.
inline constexpr double kFarLess = 1.0 / 1.2;

// Would ChooseModel keep another model than the first although the first costs far less? Then the
// first is validated by other tests too.
bool FirstDeservesAnotherTest(const std::vector<Model>& models, std::size_t first,
                              const ChoiceRules& rules);

// Of a diagnosis that has run to its end. explained: the share that what was named takes of what
// the baseline leaves above its null; is_above_discretisation: what it leaves is well above what
// mesh and step make.
Verdict VerdictOf(const Diagnosis& diagnosis, double explained, bool is_above_discretisation);

}  // namespace clothfit
