// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model_race.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "autodiff_sim/parallel.h"
#include "autodiff_sim/parameter_table.h"
#include "fitting/diagnosis/baseline_fit.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

constexpr int kMoreHeats = 3;         // of the best, until it converges
constexpr double kNearBest = 0.9;     // of what the best gains: it may come first yet
constexpr double kAlmostAsLow = 1.2;  // times the lowest cost: of a large gain any model is near
constexpr double kStillInRace = 0.5;  // of what the best has gained by then

// All cores; the numbers are the same for any.
void ForAll(std::size_t count, const std::function<void(std::size_t)>& work) {
  ParallelFor(static_cast<int>(count), NumThreads(0),
              [&](int i, int) { work(static_cast<std::size_t>(i)); });
}

}  // namespace

// From the baseline's fit, and where that is far off guided from the config's own fabric, too: a
// fabric that had to stand for what was missing is no good start.
std::optional<FittedScene> ModelRace::FirstHeat(const FittedScene& current,
                                                const RankedCandidate& candidate,
                                                const Ranking& ranking) const {
  const ModelStart start = SwitchOn(current, candidate, ranking.faults);
  std::optional<FittedScene> fitted = FitModel(current, start, kFirstIterations, runner_);
  if (ranking.residual_rms < kFarOff || Stopped()) return fitted;
  ModelStart afresh = start;
  for (auto& [name, setting] : afresh.config.parameters) {
    const ParameterSetting& told = baseline_.parameters.at(name);
    if (told.free) setting.value = told.value;
  }
  // An estimate from so far off may be anything.
  for (const NamedParameter& named : MakeParameterTable()) {
    const std::vector<std::string>& names = candidate.names;
    if (std::find(names.begin(), names.end(), named.name) == names.end()) continue;
    ParameterSetting& setting = afresh.config.parameters.at(named.name);
    setting.value = std::clamp(named.parameter.off, setting.lower, setting.upper);
  }
  std::optional<FittedScene> again = FitAfresh(afresh, Start::kGuided, kFirstIterations, runner_);
  if (!again) again = FitModel(current, afresh, kFirstIterations, runner_);
  const bool is_better = again && (!fitted || again->fit.cost_after < fitted->fit.cost_after);
  return is_better ? again : fitted;
}

// Short-listed candidates first; far off, where a linear score says little, those too that the null
// does not do as much as, until there are enough.
std::vector<const RankedCandidate*> ModelRace::Entrants(const Ranking& ranking,
                                                        double least_score) const {
  std::vector<const RankedCandidate*> entrants;
  const auto enter = [&](const auto& is_asked) {
    for (const RankedCandidate& candidate : ranking.candidates) {
      if (static_cast<int>(entrants.size()) >= options_.max_models) return;
      if (is_asked(candidate.summary)) entrants.push_back(&candidate);
    }
  };
  enter([&](const Candidate& c) { return c.is_short_listed && c.score >= least_score; });
  if (ranking.residual_rms < kFarOff || ranking.gate_p_value >= kGate) return entrants;
  enter([&](const Candidate& c) {
    return !c.is_short_listed && c.kind == CandidateKind::kPhysics &&
           c.q_value <= options_.false_discovery;
  });
  return entrants;
}

std::vector<FittedModel> ModelRace::Run(const FittedScene& current, const Ranking& ranking,
                                        double least_score) const {
  const std::vector<const RankedCandidate*> entrants = Entrants(ranking, least_score);
  std::vector<std::optional<FittedScene>> heats(entrants.size());
  std::vector<std::string> names;
  for (const RankedCandidate* entrant : entrants) names.push_back(entrant->summary.name);
  if (!names.empty()) Say("fitting with " + JoinNames(names), 0.5);
  ForAll(entrants.size(), [&](std::size_t i) {
    if (!Stopped()) heats[i] = FirstHeat(current, *entrants[i], ranking);
  });
  std::vector<FittedModel> models;
  for (std::size_t i = 0; i < heats.size(); ++i) {
    if (heats[i]) {
      models.push_back({*entrants[i], std::move(*heats[i]), {}});
    } else if (!Stopped()) {
      Log(names[i] + ": the fit with it fails");
    }
  }
  FinishModels(current, &models);
  ForAll(models.size(), [&](std::size_t i) { models[i].errors = MeasureHeldOut(models[i].scene); });
  for (const FittedModel& model : models) {
    Log(fmt::format("with {}: cost {:.6g} -> {:.6g}", model.candidate.summary.name,
                    current.fit.cost_after, model.scene.fit.cost_after));
  }
  PutBestPredictionFirst(current, &models);
  return models;
}

// Of those that explain nearly all that the best does, prediction decides: what stands for another
// effect follows the frames that it was fitted to more easily than it foresees the others.
void ModelRace::PutBestPredictionFirst(const FittedScene& current,
                                       std::vector<FittedModel>* models) const {
  if (models->empty()) return;
  const double before = current.fit.cost_after;
  const double best = models->front().scene.fit.cost_after;
  const double near = std::min(before - kNearBest * (before - best), kAlmostAsLow * best);
  const auto last = std::find_if(models->begin(), models->end(), [&](const FittedModel& model) {
    return model.scene.fit.cost_after > near;
  });
  std::stable_sort(models->begin(), last, [](const FittedModel& a, const FittedModel& b) {
    return a.errors.Rms() < b.errors.Rms();
  });
}

// Fits those further that may come first. The best is the first then.
void ModelRace::FinishModels(const FittedScene& current, std::vector<FittedModel>* models) const {
  if (models->empty()) return;
  const auto cost = [](const FittedModel& model) { return model.scene.fit.cost_after; };
  double least = current.fit.cost_after;
  for (const FittedModel& model : *models) least = std::min(least, cost(model));
  const double worst = current.fit.cost_after - kStillInRace * (current.fit.cost_after - least);
  Say("fitting those further that may come first", 0.6);
  const auto go_on = [&](double most) {
    ForAll(models->size(), [&](std::size_t i) {
      FittedModel& model = (*models)[i];
      if (cost(model) <= most) GoOnWith(&model);
    });
  };
  go_on(worst);
  const auto by_cost = [&](const FittedModel& a, const FittedModel& b) {
    return cost(a) < cost(b);
  };
  std::stable_sort(models->begin(), models->end(), by_cost);
  // Those near the best once more: the one that comes first should not be the one that is fitted
  // most easily. What the best leaves is held against the next effect, so that it has to have taken
  // its part.
  const double near = current.fit.cost_after - kNearBest * (current.fit.cost_after - least);
  go_on(near);
  std::stable_sort(models->begin(), models->end(), by_cost);
  for (int k = 1; k < kMoreHeats; ++k) GoOnWith(&models->front());
}

// Fits a model further, unless it has converged.
void ModelRace::GoOnWith(FittedModel* model) const {
  if (model->scene.fit.status == FitStatus::kConverged || Stopped()) return;
  std::optional<FittedScene> further =
      FitModel(model->scene, GoOn(model->scene), kModelIterations, runner_);
  const bool is_better = further && further->fit.cost_after < model->scene.fit.cost_after;
  if (is_better) model->scene = std::move(*further);
}

}  // namespace clothfit
