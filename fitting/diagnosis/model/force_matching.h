// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What else could make the force that a fitted model's effect makes. Two effects that a recording
// cannot tell apart push the cloth alike along the motion that both explain; scores around a
// baseline with large residuals need not say so, nor where the other would begin.
#pragma once

#include <vector>

#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

struct ForceMatch {
  Probe probe;
  Eigen::VectorXd amounts;  // of the candidate's switches
  double share = 0.0;       // of the squares of the force that it makes up for, at most 1
};

// For each candidate the place, time, shape and amounts with which its force comes nearest to that
// of `effects` (terms or full names of parameters) along the motion of `fitted`, least squares over
// all particles (N) and one instant a frame; of all its probes, and of those beside the best ones.
// Share 0 where it makes no such force, or where an amount of it is a factor of what the cloth has
// already. Empty where `fitted` cannot be simulated, or its effects make no force.
std::vector<ForceMatch> MatchForce(const FittedScene& fitted,
                                   const std::vector<std::string>& effects,
                                   const std::vector<CandidateTerm>& candidates,
                                   const Extent& extent);

}  // namespace clothfit
