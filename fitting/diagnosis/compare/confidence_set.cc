// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/confidence_set.h"

#include <algorithm>

#include "fitting/diagnosis/fitted/fit_quality.h"

namespace clothfit {
namespace {

constexpr double kSameShare = 0.1;       // of what is explained: models nearer than that are equal
constexpr double kSameSignature = 0.97;  // cosine beyond which two effects are one

// How much more than the winner a model may cost that cannot be told from it.
double MostMore(const Ranking& ranking, double best, double cost_before) {
  // Where both leave next to nothing of a large gain, what they leave decides.
  const double left = std::max(0.0, best - 0.5 * ranking.null_mean);
  const double mesh =
      0.5 * ranking.num_rows * ranking.discretisation_rms * ranking.discretisation_rms;
  return std::min(kSameShare * (cost_before - best), 2.0 * (left + mesh));
}

}  // namespace

ConfidenceSet FindConfidenceSet(const Ranking& ranking, const std::vector<FittedModel>& models,
                                std::size_t winner, double cost_before) {
  const FittedModel& best = models[winner];
  const double cost = best.scene.fit.cost_after;
  const double most = cost + MostMore(ranking, cost, cost_before);
  ConfidenceSet confidence_set{{best.candidate.summary.name}, {}};
  const bool is_physics = best.candidate.faults.empty();
  if (is_physics) confidence_set.fitted.push_back(&best.scene);
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (i == winner || !(models[i].scene.fit.cost_after < most)) continue;
    confidence_set.names.push_back(models[i].candidate.summary.name);
    // What is put right in the observation moves no cloth.
    if (is_physics && models[i].candidate.faults.empty())
      confidence_set.fitted.push_back(&models[i].scene);
  }
  if (ranking.residual_rms > kUnusableResidual)
    return confidence_set;  // the signatures are those of chaos
  for (const RankedCandidate& other : ranking.candidates) {
    const bool is_fitted = std::any_of(models.begin(), models.end(), [&](const FittedModel& m) {
      return m.candidate.summary.name == other.summary.name;
    });
    const bool is_near = other.summary.score > (1.0 - kSameShare) * best.candidate.summary.score &&
                         ranking.Cosine(other, best.candidate) > kSameSignature;
    if (!is_fitted && is_near) confidence_set.names.push_back(other.summary.name);
  }
  return confidence_set;
}

}  // namespace clothfit
