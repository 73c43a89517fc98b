// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/nudged_ranking.h"

#include <algorithm>

#include <fmt/format.h>

namespace clothfit {
namespace {

constexpr int kMostNudged = 4;
constexpr int kNudgedDraws = 2;    // of the errors of mesh and step
constexpr int kNudgedProbes = 24;  // linear as it is, the motion tells places well

}  // namespace

void RankNudged(const FittedScene& held, const DiagnosisOptions& options, Ranking* ranking) {
  RankingStart start;
  start.draws = kNudgedDraws;
  start.probes = kNudgedProbes;
  const Ranking nudged = RankCandidates(held, options, start);
  if (options.log)
    options.log(fmt::format("nudged: residuals of {:.3g} sigmas, mesh and step leave {:.3g}",
                            nudged.residual_rms, nudged.discretisation_rms));
  int num_nudged = 0;
  for (const RankedCandidate& candidate : nudged.candidates) {
    const Candidate& summary = candidate.summary;
    if (num_nudged == kMostNudged) return;
    if (summary.kind != CandidateKind::kPhysics || !summary.is_short_listed) continue;
    const auto own = std::find_if(
        ranking->candidates.begin(), ranking->candidates.end(),
        [&](const RankedCandidate& other) { return other.summary.name == summary.name; });
    if (own == ranking->candidates.end()) continue;
    ++num_nudged;
    own->summary.nudged_p_value = summary.p_value;
    std::vector<RankedCandidate::Start>& starts = own->nudged_starts;
    starts.insert(starts.begin(), candidate.other_starts.begin(), candidate.other_starts.end());
    starts.insert(starts.begin(), {candidate.probe, candidate.amounts});
    if (options.log)
      options.log(fmt::format("nudged: {} promises {:.4g}, p = {:.2g}", summary.name, summary.score,
                              summary.p_value));
  }
}

}  // namespace clothfit
