// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/guided_ranking.h"

#include <algorithm>

#include <fmt/format.h>

namespace clothfit {
namespace {

constexpr int kMostGuided = 4;
constexpr int kDraws = 2;    // of the errors of mesh and step
constexpr int kProbes = 24;  // linear as it is, the motion tells places well

}  // namespace

void RankGuided(const FittedScene& held, const DiagnosisOptions& options, Ranking* ranking) {
  RankingStart start;
  start.draws = kDraws;
  start.probes = kProbes;
  const Ranking guided = RankCandidates(held, options, start);
  if (options.log)
    options.log(fmt::format("guided: residuals of {:.3g} sigmas, mesh and step leave {:.3g}",
                            guided.residual_rms, guided.floor_rms));
  int num_guided = 0;
  for (const RankedCandidate& candidate : guided.candidates) {
    const Candidate& summary = candidate.summary;
    if (num_guided == kMostGuided) return;
    if (summary.kind != CandidateKind::kPhysics || !summary.is_short_listed) continue;
    const auto own = std::find_if(
        ranking->candidates.begin(), ranking->candidates.end(),
        [&](const RankedCandidate& other) { return other.summary.name == summary.name; });
    if (own == ranking->candidates.end()) continue;
    ++num_guided;
    own->summary.guided_p_value = summary.p_value;
    own->guided_starts = candidate.other_starts;
    own->guided_starts.insert(own->guided_starts.begin(), {candidate.probe, candidate.amounts});
    if (options.log)
      options.log(fmt::format("guided: {} promises {:.4g}, p = {:.2g}", summary.name, summary.score,
                              summary.p_value));
  }
}

}  // namespace clothfit
