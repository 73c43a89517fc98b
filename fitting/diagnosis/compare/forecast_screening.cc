// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/forecast_screening.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/fit/forecast_fit.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

constexpr std::size_t kMostJudged = 4;  // that are fitted on the deciding mesh
constexpr double kMayWin = 0.5;         // of what the best gains on the coarse one
// The share that a model explains on the deciding mesh was 0.8 to 1.3 times that on the coarse one
// (docs/adr/0026-second-effects-on-the-coarse-mesh.md).
constexpr double kOnCoarse = 0.75;
constexpr double kMayCome = 0.25;  // of what the best gains in forecasts of half that length
constexpr int kScreeningIterations = 5, kIterations = 8;  // on the coarse mesh, of each length
constexpr int kFirstLengths = 1;        // of forecasts, by which most models are put aside
constexpr std::size_t kMostStarts = 2;  // of a model
// Candidates that are fitted whatever their share: a score is linear, and misses most of what an
// effect does that changes the motion by much. Nor does it tell those apart whose scores are alike.
constexpr int kAlwaysFitted = 2;
constexpr double kAlike = 0.5;  // of the share of the first, and of obstacles before it

// The coarse mesh: forecasts are short, so that it is right about what is far behind.
std::array<int, 2> ScreeningGrid(const ClothMesh& mesh) {
  return GridWithSide(mesh.grid, std::min(kCoarseSide, LongerSide(mesh.grid)));
}

// A contact is nothing like its derivative where there is none yet: an obstacle begins at the
// shapes that make the missing force, solid at once. What carries all of the cloth at one place is
// harder than what carries it evenly. Empty where no shape is of this candidate.
std::optional<RankedCandidate> AtContacts(const FittedScene& base, const RankedCandidate& candidate,
                                          const std::vector<ContactShape>& contacts) {
  constexpr double kTimesAsHard[] = {10.0, 100.0};
  std::vector<RankedCandidate::Start> starts;
  for (const ContactShape& shape : contacts) {
    if (shape.term != candidate.term.name) continue;
    for (const double times : kTimesAsHard)
      starts.push_back({shape.probe, Eigen::VectorXd::Constant(1, times * SoftestObstacle(base))});
  }
  if (starts.empty()) return {};
  RankedCandidate solid = candidate;
  solid.probe = starts.front().probe;
  solid.amounts = starts.front().amounts;
  solid.other_starts.assign(starts.begin() + 1, starts.end());
  return solid;
}

// The same fit, looked at in its longest forecasts. Empty where they cannot be laid.
std::optional<FittedScene> InForecasts(FittedScene fitted) {
  const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
  const int count = NumForecastLengths(fitted.scene, fitted.config);
  const std::vector<int> lengths = WindowLengths(fitted.scene, fitted.config);
  double simulated_frames = 0.0;
  std::vector<LaidWindow> windows =
      LayWindows(fitted.scene, fitted.config, free, fitted.fit.theta,
                 lengths[static_cast<std::size_t>(count - 1)], nullptr, &simulated_frames);
  if (windows.empty()) return {};
  fitted.forecasts = std::make_shared<const std::vector<LaidWindow>>(std::move(windows));
  return fitted;
}

}  // namespace

bool CanForecast(const FittedScene& fitted) {
  return fitted.scene.mesh.is_grid() && NumForecastLengths(fitted.scene, fitted.config) > 0;
}

double LeftByForecasts(const FittedScene& fitted) {
  const double observed = fitted.fit.misfit ? fitted.fit.misfit->observed : 0.0;
  return std::max(0.0, fitted.fit.cost_after - 0.5 * observed);
}

double ShareOfForecasts(const FittedScene& before, const FittedScene& model) {
  const double gain = before.fit.cost_after - model.fit.cost_after, left = LeftByForecasts(before);
  return left > 0.0 ? std::clamp(gain / left, 0.0, 1.0) : 0.0;
}

void JudgeModels(const FittedScene& before, std::vector<JudgedModel>* judged) {
  if (judged->empty()) return;
  const auto best = std::min_element(
      judged->begin(), judged->end(),
      [](const JudgedModel& a, const JudgedModel& b) { return a.model.Cost() < b.model.Cost(); });
  const ResidualScale scale = ScaleOf(best->model.fine);
  for (JudgedModel& one : *judged) {
    one.log_evidence = LogEvidence(before.fit.cost_after, one.model.Cost(),
                                   static_cast<double>(one.candidate.NumUnknowns()), scale);
  }
  SortByEvidence(judged);
}

std::vector<RankedCandidate> ForecastScreening::CandidatesToFit(
    const FittedScene& base, const Ranking& ranking,
    const std::vector<ContactShape>& contacts) const {
  std::vector<RankedCandidate> candidates, obstacles;
  int count = 0;
  double least_share = options_.least_share;
  for (const RankedCandidate& candidate : ranking.candidates) {
    if (candidate.summary.kind != CandidateKind::kPhysics) continue;
    if (count == 0) least_share = std::min(least_share, kAlike * candidate.summary.share);
    if (std::optional<RankedCandidate> obstacle = AtContacts(base, candidate, contacts)) {
      obstacles.push_back(*std::move(obstacle));
    } else if (count < options_.max_models &&
               (candidate.summary.share >= least_share || count < kAlwaysFitted)) {
      candidates.push_back(candidate);
      ++count;
    }
  }
  candidates.insert(candidates.end(), obstacles.begin(), obstacles.end());
  return candidates;
}

// From either sign of its amount, where both are likely; of more starts from the cheapest ones.
std::optional<FittedScene> ForecastScreening::FitPhysics(const FittedScene& base,
                                                         const Ranking& ranking,
                                                         const RankedCandidate& candidate,
                                                         int last_length) const {
  std::vector<RankedCandidate> starts = {candidate};
  for (const RankedCandidate::Start& other : candidate.other_starts) {
    starts.push_back(candidate);
    starts.back().probe = other.probe;
    starts.back().amounts = other.amounts;
  }
  const auto fit = [&](const RankedCandidate& start, int iterations) {
    return FitToForecasts(SwitchOn(base, start, ranking.faults), base.scene.mesh.grid,
                          {0, last_length, iterations}, runner_, &base);
  };
  if (starts.size() > kMostStarts) {
    std::vector<std::pair<double, std::size_t>> costs;
    for (std::size_t i = 0; i < starts.size() && !Stopped(); ++i) {
      const std::optional<FittedScene> as_it_is = fit(starts[i], 0);
      if (as_it_is) costs.push_back({as_it_is->fit.cost_after, i});
    }
    std::sort(costs.begin(), costs.end());
    std::vector<RankedCandidate> cheapest;
    for (std::size_t k = 0; k < costs.size() && k < kMostStarts; ++k)
      cheapest.push_back(starts[costs[k].second]);
    starts = std::move(cheapest);
  }
  std::optional<FittedScene> best;
  for (const RankedCandidate& start : starts) {
    if (Stopped()) break;
    best = Cheaper(std::move(best), fit(start, kScreeningIterations));
  }
  return best;
}

// Few points of a cloth do not tell a bar from a ball by the force that they lack, but forecasts
// do: a bar begins where the ball has ended, too, if that explains more.
void ForecastScreening::AddBarThroughBall(const FittedScene& base, const Ranking& ranking,
                                          int last_length, std::vector<RankedCandidate>* candidates,
                                          std::vector<std::optional<FittedScene>>* fits) const {
  const auto find = [&](const std::string& term) {
    const auto found =
        std::find_if(candidates->begin(), candidates->end(),
                     [&](const auto& candidate) { return candidate.term.name == term; });
    return static_cast<std::size_t>(found - candidates->begin());
  };
  const std::size_t ball = find("obstacle_sphere"), bar = find("obstacle_capsule");
  if (ball == candidates->size() || bar == candidates->size() || Stopped()) return;
  const std::optional<FittedScene>&of_ball = (*fits)[ball], &of_bar = (*fits)[bar];
  if (!of_ball || (of_bar && of_bar->fit.cost_after <= of_ball->fit.cost_after)) return;
  const auto fitted = [&](const std::string& name) {
    return of_ball->values.parameters.at(name).value;
  };
  Probe shape = (*candidates)[ball].probe;
  for (auto& [name, value] : shape) value = fitted(name);
  RankedCandidate through = (*candidates)[bar];
  const Eigen::VectorXd stiffness =
      Eigen::VectorXd::Constant(1, fitted("obstacle_sphere.stiffness"));
  through.other_starts.clear();
  for (const Probe& probe : BarsThroughBall(shape, base.scene.world.gravity))
    through.other_starts.push_back({probe, stiffness});
  through.probe = through.other_starts.back().probe;
  through.amounts = stiffness;
  through.other_starts.pop_back();
  std::optional<FittedScene> fit = FitPhysics(base, ranking, through, last_length);
  if (!fit || (of_bar && of_bar->fit.cost_after <= fit->fit.cost_after)) return;
  (*candidates)[bar] = std::move(through);
  (*fits)[bar] = std::move(fit);
}

bool ForecastScreening::Decide(const FittedScene& current, const FittedScene& base,
                               const std::vector<FittedModel>& models, ForecastRound* round) const {
  const double before = base.fit.cost_after;
  std::vector<const FittedModel*> chosen;
  for (const FittedModel& model : models) {
    const bool may_win = model.scene.fit.cost_after <=
                         before - kMayWin * (before - models.front().scene.fit.cost_after);
    if (may_win && chosen.size() < kMostJudged) chosen.push_back(&model);
  }
  Say("forecasts on the deciding mesh", 0.65);
  const std::array<int, 2>& grid = current.scene.mesh.grid;
  std::vector<std::optional<FittedScene>> fits(1 + chosen.size());
  ParallelFor(static_cast<int>(fits.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    const FittedScene& coarse = k == 0 ? base : chosen[k - 1]->scene;
    if (Stopped()) return;
    fits[k] = coarse.scene.mesh.grid == grid
                  ? coarse
                  : FitToForecasts(GoOn(coarse), grid, {1}, runner_, &coarse);
  });
  if (!fits[0]) return false;
  round->before = *std::move(fits[0]);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (fits[k + 1]) round->judged.push_back({chosen[k]->candidate, {*fits[k + 1], *fits[k + 1]}});
  JudgeModels(round->before, &round->judged);
  return true;
}

std::optional<ForecastRound> ForecastScreening::Run(const FittedScene& current,
                                                    const std::vector<FittedModel>& faults,
                                                    const std::vector<ContactShape>& contacts,
                                                    double least_share) const {
  if (!CanForecast(current)) return {};
  Say("fitting forecasts", 0.45);
  const bool is_off = HasLargeResidual(current.scene, current.config, current.fit);
  const ModelStart start = is_off ? WithMaterialOf(baseline_, GoOn(current)) : GoOn(current);
  const std::array<int, 2> grid = ScreeningGrid(current.scene.mesh);
  const int first_lengths =
      std::min(kFirstLengths, NumForecastLengths(current.scene, start.config));
  const auto go_on = [&](const FittedScene& fitted) {
    return FitToForecasts(GoOn(fitted), grid, {first_lengths, kAllLengths, kIterations}, runner_,
                          &fitted);
  };
  const std::optional<FittedScene> first =
      FitToForecasts(start, grid, {0, first_lengths, kIterations}, runner_, &current);
  if (!first || Stopped()) return {};
  const std::optional<FittedScene> base = go_on(*first);
  if (!base || Stopped()) return {};
  const std::optional<FittedScene> looked_at = InForecasts(*base);
  if (!looked_at) return {};
  ForecastRound round;
  RankingStart by;
  by.draws = 0;
  by.refinements = 1;
  round.ranking = RankCandidates(*looked_at, options_, by);
  std::vector<RankedCandidate> candidates = CandidatesToFit(*base, round.ranking, contacts);
  std::vector<std::string> names;
  for (const RankedCandidate& candidate : candidates) names.push_back(candidate.summary.name);
  Log(fmt::format("forecasts leave {:.3g} sigmas; looked at: {}", round.ranking.residual_rms,
                  fmt::join(names, ", ")));
  Say("fitting forecasts with what could be missing", 0.55);
  const std::size_t count = candidates.size() + faults.size();
  const auto for_all = [&](std::size_t some, const std::function<void(std::size_t)>& work) {
    ParallelFor(static_cast<int>(some), NumThreads(0), [&](int i, int) {
      if (!Stopped()) work(static_cast<std::size_t>(i));
    });
  };
  // And the baseline once more: all begin where its longest forecasts have ended.
  std::vector<std::optional<FittedScene>> fits(count + 1);
  for_all(fits.size(), [&](std::size_t k) {
    if (k < candidates.size()) {
      fits[k] = FitPhysics(*base, round.ranking, candidates[k], first_lengths);
    } else {
      ModelStart without = GoOn(*base);
      if (k < count) without.recording = faults[k - candidates.size()].scene.scene.recording;
      fits[k] =
          FitToForecasts(without, grid, {0, first_lengths, kScreeningIterations}, runner_, &*base);
    }
  });
  AddBarThroughBall(*base, round.ranking, first_lengths, &candidates, &fits);
  const double nothing = fits.back() ? fits.back()->fit.cost_after : first->fit.cost_after;
  double least = nothing;
  for (const auto& fit : fits)
    if (fit) least = std::min(least, fit->fit.cost_after);
  const double most = nothing - kMayCome * (nothing - least);
  for_all(count, [&](std::size_t k) {
    if (!fits[k]) return;
    const bool may_come = fits[k]->fit.cost_after <= most;
    fits[k] = may_come ? go_on(*fits[k]) : std::nullopt;
  });
  std::vector<FittedModel> models;
  for (std::size_t k = 0; k < count; ++k) {
    if (!fits[k]) continue;
    models.push_back(
        {k < candidates.size() ? candidates[k] : faults[k - candidates.size()].candidate,
         std::move(*fits[k])});
  }
  if (Stopped()) return {};
  std::stable_sort(models.begin(), models.end(), IsCheaper);
  for (const FittedModel& model : models) {
    Log(fmt::format("with {}: forecasts cost {:.6g} -> {:.6g} on {} particles",
                    model.candidate.summary.name, base->fit.cost_after, model.scene.fit.cost_after,
                    base->scene.mesh.num_particles()));
  }
  const double share = models.empty() ? 0.0 : ShareOfForecasts(*base, models.front().scene);
  if (share < kOnCoarse * least_share) {
    Log(fmt::format("none explains more than {:.2g} % of what forecasts leave", 100.0 * share));
    round.before = *base;
    return round;
  }
  if (!Decide(current, *base, models, &round)) return {};
  return round;
}

}  // namespace clothfit
