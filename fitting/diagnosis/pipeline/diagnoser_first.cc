// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis kept first, looked at again once a second effect stands beside it. Backward
// elimination: a stiff patch that was kept for a stiff seam has nothing left to stand for once the
// seam has been found. Exchange: wind and a heavy patch look like a tilted gravity while the patch
// is not known, and like nothing but wind beside it.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "fitting/diagnosis/answer/verdict.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"

namespace clothfit {

std::optional<FittedModel> Diagnoser::WithoutFirst(const First& first, const FittedScene& current) {
  const FittedScene& before = first.kept.before;
  Say("fitting without " + first.kept.candidate.summary.name, 0.7);
  std::optional<FittedScene> fit =
      FitModel(current, WithOnly(before, current, kept_->candidate), 2 * kModelIterations, runner_);
  if (fit) fit = GoneOnWith(std::move(*fit));
  Spend("fitting without what was found");
  if (!fit) return {};
  Log(fmt::format("{} without {}: cost {:.6g} -> {:.6g}", kept_->candidate.summary.name,
                  first.kept.candidate.summary.name, current.fit.cost_after, fit->fit.cost_after));
  HeldOutErrors errors = MeasureHeldOut(*fit);
  return FittedModel{kept_->candidate, std::move(*fit), std::move(errors)};
}

bool Diagnoser::IsIdle(const First& first, const FittedModel& second, const FittedScene& current) {
  const FittedScene& before = first.kept.before;
  const double cost = current.fit.cost_after, gain = before.fit.cost_after - cost;
  if (second.scene.fit.cost_after > cost + kIdle * gain) return false;
  const HeldOutValidation validation =
      ValidateOnHeldOut(second, {before, first.kept.before_errors, first.ranking, options_});
  return !options_.validate || validation.is_validated;
}

// As the newest of the models, held against the fit without its newest effect.
void Diagnoser::Keep(const FittedModel& model, FittedScene before, HeldOutErrors before_errors) {
  diagnosis_.models.push_back(Describe(model, before, before_errors));
  TakeForAnswer(
      {diagnosis_.models.size() - 1, model.candidate, std::move(before), std::move(before_errors)});
}

void Diagnoser::ForgetFirst(const First& first) {
  diagnosis_.models[first.kept.model].is_kept = diagnosis_.models[kept_->model].is_kept = false;
  diagnosis_.effects = first.effects;
  kept_parameters_ = first.parameters;
}

void Diagnoser::DropFirst(First first, FittedModel second, FittedScene* current,
                          HeldOutErrors* errors) {
  const std::string& name = second.candidate.summary.name;
  Log(fmt::format("{} is dropped: {} does without it", first.kept.candidate.summary.name, name));
  ForgetFirst(first);
  last_ranking_ = first.ranking;
  const double cost_before = first.kept.before.fit.cost_after;
  Keep(second, std::move(first.kept.before), std::move(first.kept.before_errors));
  // What else it could be is what else the first round has fitted.
  std::vector<FittedModel>& models = first.models;
  models.erase(
      std::remove_if(models.begin(), models.end(),
                     [&](const FittedModel& m) { return m.candidate.summary.name == name; }),
      models.end());
  models.push_back(second);
  const std::size_t winner = models.size() - 1;
  TellApart(FindConfidenceSet(first.ranking, models, winner, cost_before));
  KeepCompetitors(models, winner);
  *current = std::move(second.scene);
  *errors = std::move(second.errors);
  ++rounds_left_;  // one effect more may be added than if it had been found at once
}

// What has not been fitted here stays as it was.
void Diagnoser::TellApartBeside(const First& first, const FittedModel& second,
                                const std::vector<FittedModel>& models, std::size_t winner) {
  const std::vector<std::string> so_far = diagnosis_.confidence_set;
  TellApart(FindConfidenceSet(first.ranking, models, winner, second.scene.fit.cost_after));
  std::vector<std::string>& set = diagnosis_.confidence_set;
  for (const std::string& name : so_far) {
    const bool is_fitted = std::any_of(models.begin(), models.end(), [&](const FittedModel& m) {
      return m.candidate.summary.name == name;
    });
    if (!is_fitted && std::find(set.begin(), set.end(), name) == set.end()) set.push_back(name);
  }
}

void Diagnoser::ExchangeFirst(const First& first, const FittedModel& second, FittedScene* current,
                              HeldOutErrors* errors) {
  const std::string& name = first.kept.candidate.summary.name;
  const std::string& beside = second.candidate.summary.name;
  const FittedModel both{first.kept.candidate, *current, *errors};
  std::vector<FittedModel> models =
      ModelScreening(baseline_, options_).FitCompetitors(second.scene, first.ranking, {both});
  for (FittedModel& model : models) {
    model.errors = MeasureHeldOut(model.scene);
    Log(fmt::format("{} instead of {} beside {}: cost {:.6g}, not {:.6g}",
                    model.candidate.summary.name, name, beside, model.scene.fit.cost_after,
                    current->fit.cost_after));
  }
  Spend("another effect in its place");
  if (models.empty() || Stopped()) return;
  models.push_back(both);
  PutBestFirst(second.scene.fit.cost_after, second.errors, first.ranking, &models);
  std::size_t winner = 0;
  while (models[winner].candidate.summary.name != name &&
         !TakesFirstPlace(first, second, models[winner], current, errors))
    ++winner;
  TellApartBeside(first, second, models, winner);
}

bool Diagnoser::TakesFirstPlace(const First& first, const FittedModel& second,
                                const FittedModel& competitor, FittedScene* current,
                                HeldOutErrors* errors) {
  if (Stopped()) return false;
  const double cost = competitor.scene.fit.cost_after, so_far = current->fit.cost_after;
  const bool is_simpler =
      cost < so_far && competitor.candidate.NumUnknowns() <= first.kept.candidate.NumUnknowns();
  if (!is_simpler && cost > kFarLess * so_far) return false;
  const HeldOutValidation of_competitor =
      Validate(competitor, so_far, {second.scene, second.errors, first.ranking, options_});
  if (options_.validate && !of_competitor.is_validated) return false;
  std::optional<FittedScene> fit = FitModel(
      competitor.scene, WithOnly(first.kept.before, competitor.scene, competitor.candidate),
      2 * kModelIterations, runner_);
  if (!fit) return false;
  FittedModel alone{competitor.candidate, GoneOnWith(std::move(*fit)), {}};
  alone.errors = MeasureHeldOut(alone.scene);
  // The second, which was validated beside the first, is to be validated beside this one.
  const FittedModel both{second.candidate, competitor.scene, competitor.errors};
  const HeldOutValidation validation =
      ValidateByAnyTest(both, {alone.scene, alone.errors, last_ranking_, options_});
  Spend("another effect in its place");
  if (options_.validate && !validation.is_validated) return false;
  Log(fmt::format("{} takes the place of {}", competitor.candidate.summary.name,
                  first.kept.candidate.summary.name));
  ForgetFirst(first);
  Keep(alone, first.kept.before, first.kept.before_errors);
  Keep(both, std::move(alone.scene), std::move(alone.errors));
  diagnosis_.answer->validation = diagnosis_.models.back().validation = validation;
  *current = competitor.scene;
  *errors = competitor.errors;
  return true;
}

void Diagnoser::LookBackAtFirst(FittedScene* current, HeldOutErrors* errors) {
  if (!first_kept_ || Stopped()) return;
  First first = std::move(*first_kept_);
  first_kept_.reset();  // a third effect is held against both
  std::optional<FittedModel> second = WithoutFirst(first, *current);
  if (!second || Stopped()) return;
  if (IsIdle(first, *second, *current)) {
    DropFirst(std::move(first), std::move(*second), current, errors);
  } else {
    ExchangeFirst(first, *second, current, errors);
  }
}

}  // namespace clothfit
