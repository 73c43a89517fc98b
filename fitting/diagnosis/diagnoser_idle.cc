// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Backward elimination: what a diagnosis kept first, taken out again. A stiff patch that was kept
// for a stiff seam has nothing left to stand for once the seam has been found beside it.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "fitting/diagnosis/diagnoser.h"
#include "fitting/diagnosis/modelling.h"

namespace clothfit {

std::optional<FittedModel> Diagnoser::WithoutFirst(const First& first, const FittedScene& current) {
  const FittedScene& before = first.kept.before;
  const std::string& name = kept_->candidate.summary.name;
  Say("fitting without " + first.kept.candidate.summary.name, 0.7);
  std::optional<FittedScene> fit =
      FitModel(current, WithOnly(before, current, kept_->candidate), 2 * kModelIterations, runner_);
  Spend("fitting without what was found");
  if (!fit) return {};
  FittedScene alone = GoneOnWith(std::move(*fit));
  const double cost = current.fit.cost_after, gain = before.fit.cost_after - cost;
  Log(fmt::format("{} without {}: cost {:.6g} -> {:.6g}", name, first.kept.candidate.summary.name,
                  cost, alone.fit.cost_after));
  if (alone.fit.cost_after > cost + kIdle * gain) return {};
  HeldOutErrors errors = MeasureHeldOut(alone);
  FittedModel model{kept_->candidate, std::move(alone), std::move(errors)};
  const HeldOutProof proof =
      ProveOnHeldOut(model, {before, first.kept.before_errors, first.ranking, options_});
  if (options_.prove && !proof.is_proven) return {};
  return model;
}

void Diagnoser::DropWhatIsIdle(FittedScene* current, HeldOutErrors* errors) {
  if (!first_kept_ || Stopped()) return;
  First first = std::move(*first_kept_);
  first_kept_.reset();  // a third effect is held against both
  std::optional<FittedModel> alone = WithoutFirst(first, *current);
  if (!alone) return;
  const std::string& name = alone->candidate.summary.name;
  Log(fmt::format("{} is dropped: {} does without it", first.kept.candidate.summary.name, name));
  diagnosis_.models[first.kept.model].is_kept = diagnosis_.models[kept_->model].is_kept = false;
  diagnosis_.effects = first.effects;
  kept_parameters_ = first.parameters;
  last_ranking_ = first.ranking;
  Model described = Describe(*alone, first.kept.before, first.kept.before_errors);
  described.is_kept = true;
  diagnosis_.effects = described.effects;
  for (const EffectParameter& p : described.parameters) kept_parameters_.push_back(p.name);
  diagnosis_.answer = described;
  diagnosis_.models.push_back(std::move(described));
  // What else it could be is what else the first round has fitted.
  std::vector<FittedModel>& models = first.models;
  models.erase(
      std::remove_if(models.begin(), models.end(),
                     [&](const FittedModel& m) { return m.candidate.summary.name == name; }),
      models.end());
  models.push_back(*alone);
  const std::size_t winner = models.size() - 1;
  TellApart(FindAmbiguity(first.ranking, models, winner, first.kept.before.fit.cost_after));
  KeepRivals(models, winner);
  kept_ = {diagnosis_.models.size() - 1, alone->candidate, std::move(first.kept.before),
           std::move(first.kept.before_errors)};
  *current = std::move(alone->scene);
  *errors = std::move(alone->errors);
  ++rounds_left_;  // one effect more may be added than if it had been found at once
}

}  // namespace clothfit
