// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A candidate with what was fitted with it.
#pragma once

#include "fitting/diagnosis/model/switch_on.h"

namespace clothfit {

struct FittedModel {
  RankedCandidate candidate;
  FittedScene scene;
};

inline bool IsCheaper(const FittedModel& a, const FittedModel& b) {
  return a.scene.fit.cost_after < b.scene.fit.cost_after;
}

}  // namespace clothfit
