// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/screening.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/explained_share.h"
#include "fitting/diagnosis/model/fault_estimate.h"
#include "fitting/diagnosis/model/force_matching.h"
#include "fitting/diagnosis/rank/default_terms.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kAlike = 0.3;  // of the squares of a force
constexpr std::size_t kMostCompetitors = 3;
constexpr int kMostFaults = 2;
constexpr int kProbes = 24;             // of what matches its force
constexpr double kPromotedShare = 0.5;  // of what the best has gained by then

// All cores; the numbers are the same for any.
void ForAll(std::size_t count, const std::function<void(std::size_t)>& work) {
  ParallelFor(static_cast<int>(count), NumThreads(0),
              [&](int i, int) { work(static_cast<std::size_t>(i)); });
}

bool IsAmong(const std::vector<RankedCandidate>& candidates, const std::string& name) {
  return std::any_of(candidates.begin(), candidates.end(), [&](const RankedCandidate& candidate) {
    return candidate.summary.name == name;
  });
}

// Of two fits of the same candidate the cheaper stays.
void Merge(std::vector<FittedModel> more, std::vector<FittedModel>* models) {
  for (FittedModel& model : more) {
    const auto same = std::find_if(models->begin(), models->end(), [&](const FittedModel& other) {
      return other.candidate.summary.name == model.candidate.summary.name;
    });
    if (same == models->end()) {
      models->push_back(std::move(model));
    } else if (IsCheaper(model, *same)) {
      *same = std::move(model);
    }
  }
  std::stable_sort(models->begin(), models->end(), IsCheaper);
}

}  // namespace

ModelStart StartAt(const FittedScene& current, RankedCandidate candidate,
                   const RankedCandidate::Start& start, const Ranking& ranking) {
  candidate.probe = start.probe;
  candidate.amounts = start.amounts;
  return SwitchOn(current, candidate, ranking.faults);
}

// From either sign of its amount, where both are likely.
std::optional<FittedScene> ModelScreening::FirstFit(const FittedScene& current,
                                                    const RankedCandidate& candidate,
                                                    const Ranking& ranking) const {
  const ModelStart start = SwitchOn(current, candidate, ranking.faults);
  std::optional<FittedScene> model =
      FitFirst(current, start, baseline_, candidate, kFirstIterations, runner_);
  for (const RankedCandidate::Start& other_start : candidate.other_starts) {
    if (Stopped()) break;
    RankedCandidate other = candidate;
    other.amounts = other_start.amounts;
    std::optional<FittedScene> fitted =
        FitFirst(current, StartAt(current, candidate, other_start, ranking), baseline_, other,
                 kFirstIterations, runner_);
    model = Cheaper(std::move(model), std::move(fitted));
  }
  return model;
}

// Physics by its score, whatever the null does as well: discretisation is the deciding mesh's
// business. Faults that are larger than in well-made recordings beside it. At large residuals,
// where a linear score says little, default terms too, each by itself and all of it together.
std::vector<RankedCandidate> ModelScreening::CandidatesToFit(const Ranking& ranking) const {
  std::vector<RankedCandidate> chosen;
  int num_physics = 0, num_faults = 0;
  for (const RankedCandidate& candidate : ranking.candidates) {
    const Candidate& c = candidate.summary;
    const bool is_physics = c.kind == CandidateKind::kPhysics;
    const bool is_worth_it = c.is_short_listed || (is_physics && c.share >= options_.least_share);
    int& count = is_physics ? num_physics : num_faults;
    if (!is_worth_it || count >= (is_physics ? options_.max_models : kMostFaults)) continue;
    ++count;
    chosen.push_back(candidate);
  }
  if (ranking.residual_rms < kLargeResidual) return chosen;
  for (const RankedCandidate& candidate : ranking.candidates) {
    if (!IsAmong(chosen, candidate.summary.name) && IsDefaultTerm(candidate))
      chosen.push_back(candidate);
  }
  if (const std::optional<RankedCandidate> all = AllDefaultTerms(ranking)) chosen.push_back(*all);
  return chosen;
}

std::vector<FittedModel> ModelScreening::RunAll(const std::vector<RankedCandidate>& screened,
                                                const Ranking& ranking,
                                                const FitOne& fit_one) const {
  std::vector<std::optional<FittedScene>> fits(screened.size());
  std::vector<std::string> names;
  for (const RankedCandidate& each : screened) names.push_back(each.summary.name);
  if (!names.empty()) Say("fitting with " + JoinNames(names), 0.5);
  ForAll(screened.size(), [&](std::size_t i) {
    if (!Stopped()) fits[i] = fit_one(screened[i]);
  });
  std::vector<FittedModel> models;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (fits[i]) {
      models.push_back({screened[i], std::move(*fits[i])});
    } else if (!Stopped()) {
      Log(names[i] + ": the fit with it fails");
    }
  }
  ForAll(models.size(),
         [&](std::size_t i) { EstimateFaultAgain(ranking.faults, runner_, &models[i]); });
  return models;
}

std::vector<FittedModel> ModelScreening::Screen(
    const FittedScene& current, const Ranking& ranking,
    const std::vector<RankedCandidate>& screened) const {
  std::vector<FittedModel> models = RunAll(
      screened, ranking,
      [&](const RankedCandidate& candidate) { return FirstFit(current, candidate, ranking); });
  FinishModels(current, kPromotedShare, &models);
  return models;
}

std::vector<FittedModel> ModelScreening::Run(const FittedScene& current,
                                             const Ranking& ranking) const {
  std::vector<FittedModel> models = Screen(current, ranking, CandidatesToFit(ranking));
  if (!models.empty() && models.front().candidate.faults.empty())
    Merge(FitCompetitors(current, ranking, models), &models);
  for (const FittedModel& model : models) {
    Log(fmt::format("with {}: cost {:.6g} -> {:.6g}", model.candidate.summary.name,
                    current.fit.cost_after, model.scene.fit.cost_after));
  }
  if (!models.empty()) TakeOutIdleParts(current, ranking, &models.front());
  return models;
}

std::vector<FittedModel> ModelScreening::FitFaults(const FittedScene& current,
                                                   const Ranking& ranking) const {
  std::vector<RankedCandidate> faults = CandidatesToFit(ranking);
  faults.erase(std::remove_if(faults.begin(), faults.end(),
                              [](const RankedCandidate& one) { return one.faults.empty(); }),
               faults.end());
  return RunAll(faults, ranking, [&](const RankedCandidate& candidate) {
    return FirstFit(current, candidate, ranking);
  });
}

// Of a model that stands for several effects: those without which it explains about as much are
// taken out of it, one after the other.
void ModelScreening::TakeOutIdleParts(const FittedScene& current, const Ranking& ranking,
                                      FittedModel* model) const {
  while (model->candidate.parts.size() > 1 && !Stopped()) {
    const std::vector<std::string>& parts = model->candidate.parts;
    Say("fitting without each of " + JoinNames(parts), 0.65);
    std::vector<std::optional<FittedModel>> without(parts.size());
    ForAll(parts.size(), [&](std::size_t i) {
      std::vector<std::string> others = parts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      std::optional<FittedScene> scene =
          FitModel(model->scene, GoOnWithout(model->scene, Together(ranking, {parts[i]}).names),
                   kModelIterations, runner_);
      if (scene) without[i] = FittedModel{Together(ranking, others), std::move(*scene)};
    });
    const double cost = model->scene.fit.cost_after;
    double highest = cost + kIdle * (current.fit.cost_after - cost);
    FittedModel* idle = nullptr;
    for (std::size_t i = 0; i < without.size(); ++i) {
      if (!without[i]) continue;
      const double left = without[i]->scene.fit.cost_after;
      Log(fmt::format("without {}: cost {:.6g} -> {:.6g}", parts[i], cost, left));
      if (left > highest) continue;
      highest = left;
      idle = &*without[i];
    }
    if (idle == nullptr) return;
    FittedModel simpler = std::move(*idle);
    *model = std::move(simpler);
  }
}

// Fits those further that may come first: that have gained this share of what the best has. The
// best is the first then.
void ModelScreening::FinishModels(const FittedScene& current, double promoted_share,
                                  std::vector<FittedModel>* models) const {
  if (models->empty()) return;
  const auto cost = [](const FittedModel& model) { return model.scene.fit.cost_after; };
  double least = current.fit.cost_after;
  for (const FittedModel& model : *models) least = std::min(least, cost(model));
  const double worst = current.fit.cost_after - promoted_share * (current.fit.cost_after - least);
  Say("fitting those further that may come first", 0.6);
  const auto go_on = [&](double most) {
    ForAll(models->size(), [&](std::size_t i) {
      FittedModel& model = (*models)[i];
      if (cost(model) <= most) GoOnWith(&model);
    });
  };
  go_on(worst);
  std::stable_sort(models->begin(), models->end(), IsCheaper);
  // Those near the best once more: the one that comes first should not be the one that is fitted
  // most easily. What the best leaves is held against the next effect, so that it has to have taken
  // its part.
  const double near = current.fit.cost_after - kNearBest * (current.fit.cost_after - least);
  go_on(near);
  std::stable_sort(models->begin(), models->end(), IsCheaper);
}

// The best three of those that could make most of the force that the first model makes and are not
// known to explain as much.
std::vector<RankedCandidate> ModelScreening::MatchingCandidates(
    const FittedScene& current, const Ranking& ranking,
    const std::vector<FittedModel>& models) const {
  Say("seeking what else could make this force", 0.63);
  const FittedModel& best = models.front();
  const double before = current.fit.cost_after;
  const double near = before - kNearBest * (before - best.scene.fit.cost_after);
  const std::vector<std::string> own = best.candidate.Effects();
  const auto is_known = [&](const std::string& name) {
    return std::find(own.begin(), own.end(), name) != own.end() ||
           std::any_of(models.begin(), models.end(), [&](const FittedModel& model) {
             return model.candidate.summary.name == name && model.scene.fit.cost_after <= near;
           });
  };
  std::vector<CandidateTerm> terms =
      ListCandidates(current.values, current.scene, ranking.extent, options_.excluded, kProbes);
  const auto last = std::remove_if(terms.begin(), terms.end(),
                                   [&](const CandidateTerm& term) { return is_known(term.name); });
  terms.erase(last, terms.end());
  const std::vector<ForceMatch> matches = MatchForce(best.scene, own, terms, ranking.extent);
  std::vector<std::pair<double, RankedCandidate>> able;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto ranked = std::find_if(
        ranking.candidates.begin(), ranking.candidates.end(),
        [&](const RankedCandidate& other) { return other.summary.name == terms[i].name; });
    if (matches[i].share < kAlike || ranked == ranking.candidates.end()) continue;
    RankedCandidate candidate = *ranked;
    candidate.names = terms[i].switches;
    candidate.probe = matches[i].probe;
    candidate.amounts = matches[i].amounts;
    able.emplace_back(matches[i].share, std::move(candidate));
  }
  std::stable_sort(able.begin(), able.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  // What has more unknowns makes more of any force: those first that have fewer than all before.
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  std::vector<std::pair<double, RankedCandidate>> chosen, others;
  for (auto& one : able) {
    const std::size_t unknowns = one.second.NumUnknowns();
    (unknowns < fewest ? chosen : others).push_back(std::move(one));
    fewest = std::min(fewest, unknowns);
  }
  std::move(others.begin(), others.end(), std::back_inserter(chosen));
  if (chosen.size() > kMostCompetitors) chosen.resize(kMostCompetitors);
  std::vector<RankedCandidate> matching;
  for (auto& [share, candidate] : chosen) {
    Log(fmt::format("{} could make {:.0f} % of the force of {}", candidate.summary.name,
                    100.0 * share, best.candidate.summary.name));
    matching.push_back(std::move(candidate));
  }
  return matching;
}

// The same material parameters are right for them, or as wrong.
std::vector<FittedModel> ModelScreening::FitCompetitors(
    const FittedScene& current, const Ranking& ranking,
    const std::vector<FittedModel>& models) const {
  const FittedScene& best = models.front().scene;
  const std::vector<RankedCandidate> screened = MatchingCandidates(current, ranking, models);
  if (screened.empty() || Stopped()) return {};
  FitConfig material = current.config;
  for (auto& [name, setting] : material.parameters)
    setting.value = best.values.parameters.at(name).value;
  std::vector<FittedModel> competitors =
      RunAll(screened, ranking, [&](const RankedCandidate& candidate) {
        const ModelStart start =
            WithMaterialOf(material, SwitchOn(current, candidate, ranking.faults));
        return FitModel(best, AtBestShare(best, start, candidate, runner_), kFirstIterations,
                        runner_);
      });
  const double before = current.fit.cost_after;
  const double gain = before - best.fit.cost_after;
  const double most = before - kPromotedShare * gain;
  ForAll(competitors.size(), [&](std::size_t i) {
    if (competitors[i].scene.fit.cost_after <= most) GoOnWith(&competitors[i]);
  });
  return competitors;
}

// Fits a model further, unless it has converged.
void ModelScreening::GoOnWith(FittedModel* model) const {
  if (model->scene.fit.status == FitStatus::kConverged || Stopped()) return;
  std::optional<FittedScene> further =
      FitModel(model->scene, GoOn(model->scene), kModelIterations, runner_);
  const bool is_better = further && further->fit.cost_after < model->scene.fit.cost_after;
  if (is_better) model->scene = std::move(*further);
}

}  // namespace clothfit
