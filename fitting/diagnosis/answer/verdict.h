// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis comes to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/prove/held_out_proof.h"

namespace clothfit {

// The share of what is missing that has to be explained by what is named.
double MostOfIt(const Diagnosis& diagnosis);

// Does a proven law take the place of the names? Where it explains a tenth of the excess more than
// they do, or half of what they leave; or hardly less, and of the same held-out frames leaves four
// fifths of their error at most. names: null for none.
bool TakesPlace(const HeldOutProof& law, double explained_by_law, const HeldOutProof* names,
                double explained_by_names);

// Does what gains so much cost on the mesh on which it was found gain enough on a finer one?
bool StandsOnFinerMesh(double gain, double gain_on_finer);

struct ChoiceRules {
  double cost_before;  // of the fit without any of the models
  double least_share;  // that a model has to explain
  bool prove;          // is what is kept to be proven?
};

// Which of the models from `first` on, the best first, is held against the baseline from where it
// ended: the first that explains enough, gains half of what the best gains and (where that is
// asked for) is proven, which is kept unless the baseline catches up; else the first of all where
// it explains enough, since it may have found a better valley without having found an effect.
struct Choice {
  std::size_t model;  // of all
  bool is_kept;
};
std::optional<Choice> ChooseModel(const std::vector<Model>& models, std::size_t first,
                                  const ChoiceRules& rules);

// What leaves this much of another's cost at most leaves far less.
inline constexpr double kFarLess = 1.0 / 1.2;

// Is another one kept as it alone is proven, while the first of all leaves far less? That should be
// proven by other means then.
bool FirstDeservesAnotherProof(const std::vector<Model>& models, std::size_t first,
                               const ChoiceRules& rules);

// Of a diagnosis that has run to its end. explained: the share that what was named takes of what
// the baseline leaves above its null; is_above_floor: what it leaves is well above what mesh and
// step make.
Verdict VerdictOf(const Diagnosis& diagnosis, double explained, bool is_above_floor);

}  // namespace clothfit
