// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Physics that the baseline lacks and that could be looked for: terms that are off, and parameters
// of terms that are on, such as a damping, that stand at their off values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "autodiff_sim/term/extent.h"
#include "fitting/config/config.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// One of the places, times and shapes at which a candidate is tried, by full parameter name.
using Probe = std::map<std::string, double>;

struct CandidateTerm {
  std::string name;  // the term's, or the parameter's full name
  std::string term;
  std::vector<std::string> switches;  // full names; off in the baseline, and they switch it on
  std::vector<bool> is_one_sided;     // may a switch only grow?
  std::vector<Probe> probes;          // at least one; empty maps where there is nothing to choose
  Role role = Role::kMayBeMissing;    // the term's
};

enum class CandidateSet {
  kCatalogue,  // what may be missing, and the missing parts of what is there
  // Features of which a law is learned (law/learn.h), with one probe each: the middle of what was
  // recorded.
  kLaws,
  kNone,  // faults of the observation alone
};

// The candidates of a fitted config, and at most `most_probes` probes each: all combinations where
// they are fewer, else a fixed choice of them spread over all values.
std::vector<CandidateTerm> ListCandidates(const FitConfig& values, const Scene& scene,
                                          const Extent& extent,
                                          const std::vector<std::string>& excluded, int most_probes,
                                          CandidateSet set = CandidateSet::kCatalogue);

// Probes beside one: each of its shape parameters by itself set to its other values, and to values
// halfway to them.
std::vector<Probe> ProbesNear(const CandidateTerm& candidate, const Probe& probe,
                              const Extent& extent, double step);

// Of a shape along a line between two places, the edge of a table or a bar that is longer than
// thick: those coordinates of both, by full name, that say how far it goes on, as far as one axis
// of the world can. It ends beyond the cloth, where nothing of that is seen, so that a fit which
// may move them takes the line out from under the cloth. Empty of other shapes.
std::vector<std::string> EndsOfLine(const Probe& probe);

// The config with candidates' switches free at their off values, by amounts where these are 0, and
// their shapes as the probes have them.
FitConfig WithProbes(const FitConfig& values,
                     const std::vector<std::pair<const CandidateTerm*, Probe>>& probes);

}  // namespace clothfit
