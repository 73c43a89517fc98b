// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a recording cannot tell from what was found.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fitting/diagnosis/model/screening.h"

namespace clothfit {

struct ConfidenceSet {
  std::vector<std::string> names;  // what was found first
  // Of physics that was fitted, what was found first; into the models. None where that is a fault.
  std::vector<const FittedScene*> fitted;
};

// models: of one round; cost_before: of the fit without any of them. Besides models[winner] those
// that cost hardly more, and candidates that were not fitted but have nearly the same score and
// signature (unless the fit was so far off that these tell nothing).
ConfidenceSet FindConfidenceSet(const Ranking& ranking, const std::vector<FittedModel>& models,
                                std::size_t winner, double cost_before);

}  // namespace clothfit
