// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A candidate as the answer tells of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/fitted/effect_parameter.h"

namespace clothfit {

enum class CandidateKind { kPhysics, kObservation };

// One candidate in the score test.
struct Candidate {
  std::string name;  // a term's, or a fault's: "camera 2: pose", "clock", "marker offsets"
  CandidateKind kind = CandidateKind::kPhysics;
  // First-order estimates at the best of the places and times that were tried.
  std::vector<EffectParameter> parameters;
  double score = 0.0;      // decrease of the sum of squares (in sigmas) that it promises
  double raw_score = 0.0;  // the same with nothing projected out
  double share = 0.0;      // score over the sum of squares that the baseline leaves
  double p_value = 1.0;    // against the re-simulated null
  double q_value = 1.0;    // after false-discovery control
  // Amount of the first parameter's vector that the null passes for in 1 of 20 recordings, in its
  // unit: less of it cannot be told from nothing here.
  double detection_limit = 0.0;
  bool is_short_listed = false;
  std::string why_not;  // where it is not
};

}  // namespace clothfit
