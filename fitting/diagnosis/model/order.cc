// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/order.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fitting/diagnosis/model/force_matching.h"

namespace clothfit {
namespace {

constexpr double kTie = 0.02;         // of what the best improves the prediction by
constexpr double kClearly = 0.2;      // of the same: what needs more unknowns to explain less
constexpr double kAlmostAsLow = 1.2;  // times the lowest cost: of a large gain any model is near

}  // namespace

bool IsCheaper(const FittedModel& a, const FittedModel& b) {
  return a.scene.fit.cost_after < b.scene.fit.cost_after;
}

void PutBestPredictionFirst(double cost_before, const HeldOutErrors& before, double by_mesh,
                            std::vector<FittedModel>* models) {
  if (models->empty()) return;
  const double best = models->front().scene.fit.cost_after;
  const double near = std::min(cost_before - kNearBest * (cost_before - best), kAlmostAsLow * best);
  const auto last = std::find_if(models->begin(), models->end(), [&](const FittedModel& model) {
    return model.scene.fit.cost_after > near;
  });
  std::stable_sort(models->begin(), last, [](const FittedModel& a, const FittedModel& b) {
    return a.errors.Rms() < b.errors.Rms();
  });
  // An attractor far away predicted what wind had done by 11.806 mm, wind by 11.812 mm.
  const double least = models->front().errors.Rms();
  const double improved = before.is_complete ? std::max(0.0, before.Rms() - least) : 0.0;
  const auto last_tied = std::find_if(models->begin(), last, [&](const FittedModel& model) {
    return model.errors.Rms() > least + kTie * improved;
  });
  std::stable_sort(models->begin(), last_tied, [](const FittedModel& a, const FittedModel& b) {
    return a.candidate.NumUnknowns() < b.candidate.NumUnknowns();
  });
  // A gust that lasted from before the first frame until after the last predicted better than the
  // wind that it was, and explained less.
  const double clearly = std::max(least + kClearly * improved, std::hypot(least, by_mesh));
  auto simpler = last;
  for (auto model = models->begin(); model != last; ++model) {
    const bool is_simpler =
        model->candidate.NumUnknowns() < models->front().candidate.NumUnknowns() &&
        IsCheaper(*model, models->front()) && model->errors.Rms() <= clearly;
    if (is_simpler && (simpler == last || IsCheaper(*model, *simpler))) simpler = model;
  }
  if (simpler != last) std::rotate(models->begin(), simpler, simpler + 1);
}

void PutSimplerTwinFirst(const Extent& extent, std::vector<FittedModel>* models) {
  constexpr double kAllOfIt = 0.95;
  if (models->empty() || !models->front().candidate.faults.empty()) return;
  const FittedModel& first = models->front();
  std::vector<CandidateTerm> terms;
  std::vector<std::size_t> simpler;
  for (std::size_t i = 1; i < models->size(); ++i) {
    const FittedModel& model = (*models)[i];
    const bool is_term = model.candidate.parts.empty() && !model.candidate.term.switches.empty();
    if (!is_term || model.candidate.NumUnknowns() >= first.candidate.NumUnknowns() ||
        !IsCheaper(model, first))
      continue;
    terms.push_back(model.candidate.term);
    simpler.push_back(i);
  }
  if (terms.empty()) return;
  const std::vector<ForceMatch> matches =
      MatchForce(first.scene, first.candidate.Effects(), terms, extent);
  std::optional<std::size_t> twin;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const bool is_twin = matches[k].share >= kAllOfIt;
    if (is_twin && (!twin || IsCheaper((*models)[simpler[k]], (*models)[*twin]))) twin = simpler[k];
  }
  if (!twin) return;
  const auto found = models->begin() + static_cast<std::ptrdiff_t>(*twin);
  std::rotate(models->begin(), found, found + 1);
}

void PutBestFirst(double cost_before, const HeldOutErrors& before, const Ranking& ranking,
                  std::vector<FittedModel>* models) {
  std::stable_sort(models->begin(), models->end(), IsCheaper);
  PutBestPredictionFirst(cost_before, before, ranking.PredictionError(), models);
  PutSimplerTwinFirst(ranking.extent, models);
}

}  // namespace clothfit
