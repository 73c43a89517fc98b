// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/forecast_screening.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
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
// Of what the best gains on the coarse one. The best of the deciding one had gained 0.77 at least
// there, in 33 rounds of recordings by others, of real cloth and of finite elements.
constexpr double kMayWin = 0.7;
// The share that a model explains on the deciding mesh was 0.8 to 1.3 times that on the coarse one
// (docs/adr/0026-second-effects-on-the-coarse-mesh.md).
constexpr double kOnCoarse = 0.75;
constexpr double kMayCome = 0.25;  // of what the best gains in forecasts of half that length
constexpr int kScreeningIterations = 5, kIterations = 8;  // on the coarse mesh, of each length
constexpr int kFirstLengths = 1;        // of forecasts, by which most models are put aside
constexpr std::size_t kMostStarts = 2;  // of a model
constexpr double kAlikeStarts = 0.9;    // of what the better of its starts gains in the same
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

// Two starts of one candidate from which a fit comes to about the same: they differ in how much.
bool AreAlike(const RankedCandidate& a, const RankedCandidate& b) {
  return a.probe == b.probe && a.amounts.dot(b.amounts) > 0.0;
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

// Of physics, as fitted.
std::string AmountsIn(const FittedScene& model, const RankedCandidate& candidate) {
  std::string words;
  if (candidate.summary.kind != CandidateKind::kPhysics) return words;
  const auto say = [&](const std::string& name) {
    words += fmt::format(" {} {:.3g}", name, model.values.parameters.at(name).value);
  };
  for (const std::string& name : candidate.names) say(name);
  for (const auto& [name, value] : candidate.probe) say(name);
  return words.empty() ? words : ":" + words;
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
      candidates.push_back(AtShares(candidate));
      ++count;
    }
  }
  candidates.insert(candidates.end(), obstacles.begin(), obstacles.end());
  return candidates;
}

// Of a candidate's starts the cheapest that are not alike.
std::vector<RankedCandidate> ForecastScreening::StartsOf(const FittedScene& base,
                                                         const Ranking& ranking,
                                                         const RankedCandidate& candidate) const {
  std::vector<RankedCandidate> starts = {candidate};
  for (const RankedCandidate::Start& other : candidate.other_starts) {
    starts.push_back(candidate);
    starts.back().probe = other.probe;
    starts.back().amounts = other.amounts;
  }
  if (starts.size() == 1) return starts;
  std::vector<std::pair<double, std::size_t>> costs;
  for (std::size_t i = 0; i < starts.size() && !Stopped(); ++i) {
    const std::optional<FittedScene> as_it_is = FitFirstLengths(base, ranking, starts[i], 0);
    if (as_it_is) costs.push_back({as_it_is->fit.cost_after, i});
  }
  std::sort(costs.begin(), costs.end());
  std::vector<RankedCandidate> cheapest;
  for (const auto& [cost, i] : costs) {
    const bool is_new =
        std::none_of(cheapest.begin(), cheapest.end(),
                     [&, k = i](const RankedCandidate& one) { return AreAlike(one, starts[k]); });
    if (is_new && cheapest.size() < kMostStarts) cheapest.push_back(starts[i]);
  }
  return cheapest;
}

std::optional<FittedScene> ForecastScreening::FitFirstLengths(const FittedScene& base,
                                                              const Ranking& ranking,
                                                              const RankedCandidate& start,
                                                              int most_iterations) const {
  return FitToForecasts(SwitchOn(base, start, ranking.faults), base.scene.mesh.grid,
                        {0, kFirstLengths, most_iterations}, runner_, &base);
}

// Few points of a cloth do not tell a bar from a ball by the force that they lack, but forecasts
// do: a bar begins through the ball, too, if that explains more.
void ForecastScreening::AddBarThroughBall(const FittedScene& base, const Ranking& ranking,
                                          std::vector<Attempt>* attempts) const {
  const auto best_of = [&](const std::string& term) {
    const Attempt* best = nullptr;
    for (const Attempt& one : *attempts) {
      if (!one.fit || one.candidate.term.name != term) continue;
      if (!best || one.fit->fit.cost_after < best->fit->fit.cost_after) best = &one;
    }
    return best;
  };
  const std::string bar_term = "obstacle_capsule";
  const auto is_bar = [&](const Attempt& one) { return one.candidate.term.name == bar_term; };
  const Attempt* const ball = best_of("obstacle_sphere");
  const auto bar = std::find_if(attempts->begin(), attempts->end(), is_bar);
  if (ball == nullptr || bar == attempts->end() || Stopped()) return;
  const Attempt* const best_bar = best_of(bar_term);
  if (best_bar && best_bar->fit->fit.cost_after <= ball->fit->fit.cost_after) return;
  const auto fitted = [&](const std::string& name) {
    return ball->fit->values.parameters.at(name).value;
  };
  Probe shape = ball->candidate.probe;
  for (auto& [name, value] : shape) value = fitted(name);
  RankedCandidate through = bar->candidate;
  const Eigen::VectorXd stiffness =
      Eigen::VectorXd::Constant(1, fitted("obstacle_sphere.stiffness"));
  through.other_starts.clear();
  const double reach = base.scene.recording.cloth.size.maxCoeff();
  for (const Probe& probe : BarsThroughBall(shape, base.scene.world.gravity, reach))
    through.other_starts.push_back({probe, stiffness});
  through.probe = through.other_starts.back().probe;
  through.amounts = stiffness;
  through.other_starts.pop_back();
  const std::size_t group = bar->group;
  for (const RankedCandidate& start : StartsOf(base, ranking, through))
    attempts->push_back(
        {start, group, FitFirstLengths(base, ranking, start, kScreeningIterations)});
}

// Those that go on to longer forecasts: of each candidate the cheapest, and another start where
// first forecasts do not tell the two apart.
std::vector<ForecastScreening::Attempt> ForecastScreening::GoingOn(std::vector<Attempt> attempts,
                                                                   double nothing) const {
  double least = nothing;
  std::map<std::size_t, double> least_of;  // by group
  for (const Attempt& one : attempts) {
    if (!one.fit) continue;
    const double cost = one.fit->fit.cost_after;
    least = std::min(least, cost);
    const auto [found, is_first] = least_of.emplace(one.group, cost);
    if (!is_first) found->second = std::min(found->second, cost);
  }
  const auto ends = [&](const Attempt& one) {
    if (!one.fit) return true;
    const double gain = nothing - one.fit->fit.cost_after;
    return gain < kMayCome * (nothing - least) ||
           gain < kAlikeStarts * (nothing - least_of.at(one.group));
  };
  attempts.erase(std::remove_if(attempts.begin(), attempts.end(), ends), attempts.end());
  return attempts;
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
  const auto go_on = [&](const FittedScene& fitted) {
    return FitToForecasts(GoOn(fitted), grid, {kFirstLengths, kAllLengths, kIterations}, runner_,
                          &fitted);
  };
  const std::optional<FittedScene> first =
      FitToForecasts(start, grid, {0, kFirstLengths, kIterations}, runner_, &current);
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
  const auto for_all = [&](std::size_t some, const std::function<void(std::size_t)>& work) {
    ParallelFor(static_cast<int>(some), NumThreads(0), [&](int i, int) {
      if (!Stopped()) work(static_cast<std::size_t>(i));
    });
  };
  std::vector<std::vector<RankedCandidate>> starts(candidates.size());
  for_all(starts.size(),
          [&](std::size_t k) { starts[k] = StartsOf(*base, round.ranking, candidates[k]); });
  std::vector<Attempt> attempts;
  for (std::size_t k = 0; k < starts.size(); ++k)
    for (RankedCandidate& one : starts[k]) attempts.push_back({std::move(one), k, {}});
  const std::size_t of_physics = attempts.size();
  for (const FittedModel& fault : faults)
    attempts.push_back({fault.candidate, candidates.size() + attempts.size(), {}});
  // And the baseline once more: all begin where its longest forecasts have ended.
  std::optional<FittedScene> once_more;
  for_all(attempts.size() + 1, [&](std::size_t k) {
    if (k < of_physics) {
      attempts[k].fit =
          FitFirstLengths(*base, round.ranking, attempts[k].candidate, kScreeningIterations);
      return;
    }
    ModelStart without = GoOn(*base);
    if (k < attempts.size()) without.recording = faults[k - of_physics].scene.scene.recording;
    (k < attempts.size() ? attempts[k].fit : once_more) =
        FitToForecasts(without, grid, {0, kFirstLengths, kScreeningIterations}, runner_, &*base);
  });
  AddBarThroughBall(*base, round.ranking, &attempts);
  attempts = GoingOn(std::move(attempts), (once_more ? *once_more : *first).fit.cost_after);
  for_all(attempts.size(), [&](std::size_t k) { attempts[k].fit = go_on(*attempts[k].fit); });
  if (Stopped()) return {};
  const auto is_cheaper = [](const Attempt& a, const Attempt& b) {
    return a.fit && (!b.fit || a.fit->fit.cost_after < b.fit->fit.cost_after);
  };
  std::stable_sort(attempts.begin(), attempts.end(), is_cheaper);
  std::vector<FittedModel> models;
  std::set<std::size_t> groups;  // of which the cheapest is among them
  for (Attempt& one : attempts) {
    if (one.fit && groups.insert(one.group).second)
      models.push_back({std::move(one.candidate), *std::move(one.fit)});
  }
  for (const FittedModel& model : models) {
    Log(fmt::format("with {}: forecasts cost {:.6g} -> {:.6g} on {} particles{}",
                    model.candidate.summary.name, base->fit.cost_after, model.scene.fit.cost_after,
                    base->scene.mesh.num_particles(), AmountsIn(model.scene, model.candidate)));
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
