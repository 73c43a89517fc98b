// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The rounds of a diagnosis: each finds one effect.
#include "fitting/diagnosis/pipeline/diagnose.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/answer/parameter_intervals.h"
#include "fitting/diagnosis/classify/discrepancy_class.h"
#include "fitting/diagnosis/compare/forecast_screening.h"
#include "fitting/diagnosis/compare/separating_motion.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/locate/discrepancy_pictures.h"
#include "fitting/diagnosis/locate/locate_missing_force.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "fitting/diagnosis/validate/model_validation.h"
#include "fitting/rollout/shooting_windows.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr std::size_t kMostJudged = 3;  // that are fitted on the deciding mesh
constexpr double kMayWin = 0.5;         // of what the best gains on the coarse one
constexpr int kMostContinuations = 2;   // of those near the best, on the deciding mesh
constexpr double kCatchesUpFrom = 1.5;  // times the least cost: a model may come first yet
constexpr int kMostRestarts = 2;        // of a diagnosis

// May the fit be somewhere else than the recorded cloth? (Beyond any mesh, what is ordinary comes
// first.)
bool IsWorthNudging(const FittedScene& fitted, const Ranking& ranking) {
  return HasPoints(fitted.scene) && ranking.residual_rms < kUnusableResidual &&
         MayBeLocalMinimum(fitted.scene, fitted.config, fitted.fit);
}

}  // namespace

void Diagnoser::Spend(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  diagnosis_.seconds.push_back({stage, std::chrono::duration<double>(now - mark_).count()});
  mark_ = now;
}

void Diagnoser::SpendOn(const Ranking& ranking) {
  for (const auto& [part, seconds] : ranking.seconds)
    diagnosis_.seconds.push_back({"ranking: " + part, seconds});
  mark_ = std::chrono::steady_clock::now();
}

// Swapped markers are put right at once: nothing else can be said before.
FittedScene Diagnoser::UndoSwaps(FittedScene fitted) {
  constexpr int kMost = 8;
  for (int k = 0; k < kMost && !Stopped(); ++k) {
    std::vector<Eigen::VectorXd> positions;
    const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
    SimulateFrames(fitted.scene, fitted.config, free, fitted.fit.theta,
                   fitted.scene.last_fitted_frame,
                   [&](int, const State& state) { positions.push_back(state.x); });
    const std::vector<SwappedMarkers> swaps = FindSwappedMarkers(fitted.scene, positions);
    if (swaps.empty()) break;
    const SwappedMarkers& swap = swaps.front();
    const std::string name = fmt::format("markers {} and {} swapped from frame {} on",
                                         swap.first_id, swap.second_id, swap.from_frame);
    ModelStart start = GoOn(fitted);
    start.recording = SwapBack(fitted.scene.recording, swap);
    std::optional<FittedScene> again = FitModel(fitted, start, kModelIterations, runner_);
    if (!again || !(again->fit.cost_after < fitted.fit.cost_after)) {
      Log(name + ": the fit is no better without");
      break;
    }
    Log(name);
    swaps_.push_back(name);
    fitted = std::move(*again);
  }
  return fitted;
}

// Where the cloth may be somewhere else than the recorded one, no force leads it there: then along
// the motion that is nudged to what was seen.
void Diagnoser::LocateDiscrepancy(const FittedScene& fitted, const Ranking& ranking) {
  if (Stopped()) return;
  Say("locating what is missing", 0.4);
  std::optional<FittedScene> nudged;
  if (options_.nudge && IsWorthNudging(fitted, ranking))
    nudged = FitNudged(WithMaterialOf(baseline_, GoOn(fitted)), kScoringDamping, runner_);
  const std::optional<LocatedForce> found =
      nudged ? LocateMissingForce(*nudged, options_)
             : LocateMissingForce(fitted, options_, ranking.errors.get());
  Spend("locating");
  if (!found) {
    Log("the missing force cannot be estimated: the simulation fails");
    return;
  }
  diagnosis_.discrepancy = found->location.discrepancy;
  Log(found->location.discrepancy.words);
  if (!found->location.discrepancy.is_significant) return;
  // What is one source's has no class.
  const Scene& scene = found->fitted.scene;
  if (found->Blamed() == nullptr) {
    diagnosis_.discrepancy_class =
        ClassifyDiscrepancy(scene, found->missing, found->location).discrepancy_class;
  }
  missing_.emplace(found->missing);
  pushes_ = StrongestPushes(scene.mesh, found->missing);
  diagnosis_.discrepancy_pictures = {DrawForceMap(scene, found->missing, found->location),
                                     DrawForceArrows(scene, found->missing, found->location)};
}

void Diagnoser::TellOfBaseline() {
  diagnosis_.residual_rms = std::sqrt(quality_->scale.chi_square);
  diagnosis_.discretisation_rms = quality_->mesh;
  diagnosis_.misfit = quality_->result.misfit;
  diagnosis_.baseline = now_.fine.config;
  diagnosis_.baseline_fit = quality_->result;
  diagnosis_.motions.baseline = SimulateFitted(now_.fine);
  diagnosis_.motions.resolution = now_.fine.scene.mesh.grid;
  baseline_quality_ = quality_;
}

void Diagnoser::TellOfNull(const Ranking& ranking) {
  diagnosis_.gate_p_value = ranking.gate_p_value;
  diagnosis_.left_rms = ranking.left_rms;
  diagnosis_.null_left_rms = ranking.null_left_rms;
  diagnosis_.promised = ranking.promised;
  if (!quality_->result.misfit) diagnosis_.discretisation_rms = ranking.discretisation_rms;
}

void Diagnoser::TellCandidates(const Ranking& of_physics, const Ranking& of_faults) {
  diagnosis_.ranking.clear();
  for (const RankedCandidate& one : of_physics.candidates)
    if (one.faults.empty()) diagnosis_.ranking.push_back(one.summary);
  for (const RankedCandidate& one : of_faults.candidates)
    if (!one.faults.empty()) diagnosis_.ranking.push_back(one.summary);
  std::stable_sort(diagnosis_.ranking.begin(), diagnosis_.ranking.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
}

// Of points, on the deciding mesh; outlines alone are held to simulated recordings of the baseline.
bool Diagnoser::IsExplained(const Ranking& ranking) const {
  if (quality_->result.misfit) return quality_->is_explained;
  return ranking.gate_p_value >= kGate;
}

std::map<std::string, std::vector<Probe>> Diagnoser::ContactProbes() const {
  std::map<std::string, std::vector<Probe>> probes;
  for (const ContactStart& start : ContactStarts(pushes_, now_.fine.scene.world.gravity)) {
    probes[start.term].push_back(start.probe);
    std::string words;
    for (const auto& [name, value] : start.probe) words += fmt::format(" {} {:.3g}", name, value);
    Log("the missing force pushes as from" + words);
  }
  return probes;
}

std::vector<FittedModel> Diagnoser::Screen(const Ranking& ranking) {
  std::vector<FittedModel> models = ModelScreening(baseline_, options_).Run(now_.coarse, ranking);
  Spend("fitting models");
  return models;
}

// Its effect is put on the baseline there, by windows where there are points; else it goes on from
// the baseline's material or, far off, where that had to stand for what was missing, from its own.
std::optional<BothMeshes> Diagnoser::RefineModel(const FittedModel& model) const {
  const FittedScene& fine = now_.fine;
  const bool is_one_mesh = fine.scene.mesh.grid == model.scene.scene.mesh.grid;
  if (is_one_mesh) return meshes_.Refine(model.scene, 2 * kModelIterations);
  ModelStart start = WithEffectOf(model.scene, model.candidate, fine);
  start.recording = model.scene.scene.recording;
  std::optional<FittedScene> fitted;
  if (FitsWindows(fine.scene, start.config)) {
    fitted = FitAfresh(start, Start::kWindows, 2 * kModelIterations, runner_, kEnoughToDecide);
  } else if (HasLargeResidual(fine.scene, fine.config, fine.fit)) {
    return meshes_.Refine(model.scene, 2 * kModelIterations);
  } else {
    fitted = FitModel(fine, start, 2 * kModelIterations, runner_, kEnoughToDecide);
  }
  if (!fitted) return {};
  return BothMeshes{model.scene, std::move(*fitted)};
}

// The model that is fitted most easily is not to come first for that.
void Diagnoser::GoOnWithTheBest(std::vector<JudgedModel>* judged) const {
  double least = now_.Cost();
  for (const JudgedModel& one : *judged) least = std::min(least, one.model.Cost());
  const double near = kCatchesUpFrom * least;
  ParallelFor(static_cast<int>(judged->size()), NumThreads(0), [&](int i, int) {
    FittedScene& fine = (*judged)[static_cast<std::size_t>(i)].model.fine;
    if (fine.fit.cost_after > near || fine.fit.status == FitStatus::kConverged) return;
    fine =
        *Cheaper(fine, FitModel(fine, GoOn(fine), 2 * kModelIterations, runner_, kEnoughToDecide));
  });
}

std::vector<JudgedModel> Diagnoser::Decide(const std::vector<FittedModel>& models) {
  std::vector<const FittedModel*> chosen;
  const double before = now_.coarse.fit.cost_after;
  for (const FittedModel& model : models) {
    const double best = models.front().scene.fit.cost_after;
    const bool may_win = model.scene.fit.cost_after <= before - kMayWin * (before - best);
    if (may_win && chosen.size() < kMostJudged) chosen.push_back(&model);
  }
  Say("fitting the best on the deciding mesh", 0.65);
  std::vector<std::optional<BothMeshes>> fits(chosen.size());
  ParallelFor(static_cast<int>(chosen.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    if (!Stopped()) fits[k] = RefineModel(*chosen[k]);
  });
  std::vector<JudgedModel> judged;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (fits[k]) judged.push_back({chosen[k]->candidate, std::move(*fits[k])});
  for (int k = 0; k < kMostContinuations && !Stopped(); ++k) GoOnWithTheBest(&judged);
  Spend("deciding mesh");
  return judged;
}

void Diagnoser::Judge(const FittedScene& before, std::vector<JudgedModel>* judged) const {
  JudgeModels(before, judged);
  for (const JudgedModel& one : *judged) {
    Log(fmt::format("with {}: cost {:.6g} -> {:.6g} on {} particles, log evidence {:.4g}",
                    one.candidate.summary.name, before.fit.cost_after, one.model.Cost(),
                    one.model.fine.scene.mesh.num_particles(), one.log_evidence));
  }
}

bool Diagnoser::CatchesUp(std::vector<JudgedModel>* judged) {
  const JudgedModel& best = judged->front();
  if (restarts_ == kMostRestarts || Stopped() || best.log_evidence < kStrongEvidence) return false;
  Say("fitting without " + best.candidate.summary.name, 0.7);
  std::optional<FittedScene> again =
      FitModel(best.model.fine, WithoutEffect(now_.fine, best.model.fine), kModelIterations,
               runner_, kEnoughToDecide);
  Spend("fitting without what was found");
  const double before = now_.Cost();
  if (!again || !(again->fit.cost_after < before)) return false;
  Log(fmt::format("without {}, begun where that has ended: cost {:.6g}, not {:.6g}",
                  best.candidate.summary.name, again->fit.cost_after, before));
  now_.fine = std::move(*again);
  Judge(now_.fine, judged);
  if (judged->front().log_evidence >= kStrongEvidence) return false;
  std::optional<BothMeshes> both = meshes_.Coarsen(now_.fine, kModelIterations);
  if (!both) return false;
  ++restarts_;
  now_ = std::move(*both);
  return true;
}

HeldOutValidation Diagnoser::ValidateOn(const FittedScene& model, const FittedScene& before,
                                        const RankedCandidate& candidate,
                                        const Ranking& ranking) const {
  // What mesh and step do to a prediction is held against physics, not against a camera.
  const double by_mesh = candidate.faults.empty() ? last_ranking_.PredictionError() : 0.0;
  return ValidateOnHeldOut(model, before, FaultySource(candidate, ranking), by_mesh, options_.seed);
}

std::vector<std::string> Diagnoser::EffectsSoFar() const {
  std::vector<std::string> effects = swaps_;
  for (const Kept& kept : kept_) {
    for (const std::string& effect : kept.candidate.Effects()) {
      const bool is_again =  // a fault that is put right once more
          std::find(effects.begin(), effects.end(), effect) != effects.end();
      if (!is_again) effects.push_back(effect);
    }
  }
  return effects;
}

std::vector<std::string> Diagnoser::ParametersSoFar() const {
  std::vector<std::string> names;
  for (const Kept& kept : kept_) {
    if (!kept.IsPhysics()) continue;
    names.insert(names.end(), kept.candidate.names.begin(), kept.candidate.names.end());
    for (const auto& [name, value] : kept.candidate.probe) names.push_back(name);
  }
  return names;
}

// Beside what was kept.
Model Diagnoser::Describe(const JudgedModel& one, const FittedScene& before) const {
  Model described;
  described.effects = EffectsSoFar();
  for (const std::string& effect : one.candidate.Effects()) described.effects.push_back(effect);
  const FittedScene& fine = one.model.fine;
  described.config = fine.values;
  described.cost = fine.fit.cost_after;
  described.log_evidence = one.log_evidence;
  described.explained = fine.of_forecasts ? ShareOfForecasts(before, fine) : Explained(fine);
  std::vector<std::string> names = ParametersSoFar();
  if (one.candidate.faults.empty()) {
    names.insert(names.end(), one.candidate.names.begin(), one.candidate.names.end());
    for (const auto& [name, value] : one.candidate.probe) names.push_back(name);
  } else {
    described.parameters = one.candidate.summary.parameters;
  }
  const std::vector<EffectParameter> estimates = EstimatesOf(fine.fit, fine.config, names);
  described.parameters.insert(described.parameters.end(), estimates.begin(), estimates.end());
  described.validation = ValidateOn(fine, now_.fine, one.candidate, last_ranking_);
  return described;
}

void Diagnoser::TellApart(const std::vector<JudgedModel>& judged) {
  diagnosis_.confidence_set.clear();
  diagnosis_.separating.reset();
  std::vector<const FittedScene*> fitted;
  for (const JudgedModel& c : judged) {
    if (c.log_evidence < judged.front().log_evidence - kStrongEvidence) continue;
    diagnosis_.confidence_set.push_back(c.candidate.summary.name);
    // What is put right in the observation moves no cloth.
    if (c.candidate.faults.empty()) fitted.push_back(&c.model.fine);
  }
  if (fitted.size() < 2) return;
  diagnosis_.separating = FindSeparatingMotion(fitted);
  Spend("separating motion");
}

bool Diagnoser::HasPhysics() const {
  return std::any_of(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.IsPhysics(); });
}

void Diagnoser::Keep(std::vector<JudgedModel> judged, Ranking ranking) {
  const bool is_physics = judged.front().candidate.faults.empty();
  const bool is_first = !HasPhysics();
  if (is_first) TellApart(judged);
  BothMeshes before = std::move(now_);
  now_ = judged.front().model;
  RankedCandidate candidate = judged.front().candidate;
  kept_.push_back({std::move(candidate), std::move(before), std::move(ranking), std::move(judged)});
  if (is_physics && !is_first) LookBack();
  if (now_.fine.of_forecasts) {
    GoOnBeyondForecasts();
  } else if (!is_physics) {
    FitAgainWithoutFault();
  }
}

void Diagnoser::GoOnBeyondForecasts() {
  Say("fitting all frames", 0.75);
  std::optional<FittedScene> fine = FitBeyondForecasts(now_.fine, 2 * kModelIterations, runner_);
  const bool may_gain = fine && fine->fit.status != FitStatus::kConverged && !Stopped() &&
                        !HasLargeResidual(fine->scene, fine->config, fine->fit);
  if (may_gain) {
    fine =
        Cheaper(fine, FitModel(*fine, GoOn(*fine), 2 * kModelIterations, runner_, kEnoughToDecide));
  }
  std::optional<BothMeshes> both =
      fine ? meshes_.Coarsen(*fine, kModelIterations) : std::optional<BothMeshes>();
  if (both) now_ = std::move(*both);
  Spend("fitting what was kept to all frames");
}

std::optional<FittedScene> Diagnoser::FitLike(const FittedScene& other, const ModelStart& start,
                                              int most_iterations) const {
  if (!other.of_forecasts) return FitModel(other, start, most_iterations, runner_);
  return FitToForecasts(start, other.scene.mesh.grid, 1, runner_, &other);
}

// A baseline that had to follow a wrong camera may be in a local minimum, and begins anew.
void Diagnoser::FitAgainWithoutFault() {
  const FittedScene& coarse = now_.coarse;
  if (Stopped() || !HasLargeResidual(coarse.scene, coarse.config, coarse.fit)) return;
  FitConfig baseline = baseline_;
  baseline.resolution = coarse.config.resolution;
  for (const std::string& name : ParametersSoFar())
    baseline.parameters[name] = coarse.config.parameters.at(name);
  const FittedScene again = FitBaseline(coarse.scene.recording, baseline, options_);
  Log(fmt::format("without the fault, begun anew: cost {:.6g} -> {:.6g}", coarse.fit.cost_after,
                  again.fit.cost_after));
  if (again.fit.cost_after < coarse.fit.cost_after) {
    std::optional<BothMeshes> both = meshes_.Refine(again, baseline_.max_iterations);
    if (both && both->Cost() < now_.Cost()) now_ = std::move(*both);
  }
  Spend("baseline without the fault");
}

// Backward elimination: a stiff patch that was kept for a stiff seam has nothing left to stand for
// once the seam has been found. Exchange: wind and a heavy patch look like a tilted gravity while
// the patch is not known, and like nothing but wind beside it.
void Diagnoser::LookBack() {
  if (Stopped()) return;
  const auto first_physics =
      std::find_if(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.IsPhysics(); });
  const auto first = static_cast<std::size_t>(first_physics - kept_.begin());
  const RankedCandidate second = kept_.back().candidate;
  const BothMeshes& before = first_physics->before;
  Say("fitting without " + first_physics->candidate.summary.name, 0.7);
  std::optional<FittedScene> alone =
      FitLike(now_.fine, WithOnly(before.fine, now_.fine, second), 2 * kModelIterations);
  Spend("fitting without what was found");
  if (!alone) return;
  std::vector<JudgedModel> both = {{first_physics->candidate, now_}};
  for (const JudgedModel& rival : first_physics->rivals) {
    const bool is_other = rival.candidate.summary.name != first_physics->candidate.summary.name &&
                          rival.candidate.summary.name != second.summary.name;
    if (!is_other || !rival.candidate.faults.empty() || Stopped()) continue;
    std::optional<FittedScene> beside = FitLike(
        rival.model.fine, WithEffectOf(now_.fine, second, rival.model.fine), kModelIterations);
    if (beside) both.push_back({rival.candidate, {rival.model.coarse, std::move(*beside)}});
  }
  Spend("another effect in its place");
  Judge(*alone, &both);
  if (both.front().log_evidence < kStrongEvidence) {
    Log(fmt::format("{} is dropped: {} does without it", first_physics->candidate.summary.name,
                    second.summary.name));
    std::optional<BothMeshes> meshes = OnBoth(*alone);
    if (!meshes) return;
    Kept last = std::move(kept_.back());
    last.before = before;
    kept_.pop_back();
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(first));
    kept_.push_back(std::move(last));
    now_ = std::move(*meshes);
    diagnosis_.confidence_set = {second.summary.name};
    diagnosis_.separating.reset();
    ++rounds_left_;  // one effect more may be added than if it had been found at once
    return;
  }
  PutInPlaceOf(first, std::move(both));
}

// What is of forecasts will be gone on with to all frames, and comes to the coarse mesh then.
std::optional<BothMeshes> Diagnoser::OnBoth(const FittedScene& fine) const {
  if (fine.of_forecasts) return BothMeshes{fine, fine};
  return meshes_.Coarsen(fine, kModelIterations);
}

// both: of models that have the newest effect besides.
void Diagnoser::PutInPlaceOf(std::size_t first, std::vector<JudgedModel> both) {
  Kept& kept = kept_[first];
  const JudgedModel& best = both.front();
  if (best.candidate.summary.name != kept.candidate.summary.name) {
    std::optional<BothMeshes> meshes = OnBoth(best.model.fine);
    if (!meshes) return;
    Log(fmt::format("{} takes the place of {}", best.candidate.summary.name,
                    kept.candidate.summary.name));
    kept.candidate = best.candidate;
    now_ = std::move(*meshes);
  }
  TellApart(both);
}

bool Diagnoser::AddEffect() {
  const bool is_first = kept_.empty();
  if (!quality_) {
    Say("test of fit", 0.3);
    quality_ = AppraiseQuality(now_.fine);
    Spend("test of fit");
  }
  if (is_first) TellOfBaseline();
  if (quality_->is_explained) return false;
  Say("ranking what could be missing", 0.3);
  Ranking ranking = RankCandidates(now_.coarse, options_, {last_ranking_.errors});
  SpendOn(ranking);
  Log(
      fmt::format("residuals of {:.3g} sigmas on {} particles; on {} of {:.3g}, of which mesh and "
                  "step leave {:.3g}; p = {:.2g}",
                  std::sqrt(quality_->scale.chi_square), now_.fine.scene.mesh.num_particles(),
                  now_.coarse.scene.mesh.num_particles(), ranking.residual_rms,
                  ranking.discretisation_rms, ranking.gate_p_value));
  last_ranking_ = ranking;
  if (is_first) {
    TellOfNull(ranking);
    TellCandidates(ranking, ranking);
  }
  if (IsExplained(ranking)) return false;
  if (is_first) LocateDiscrepancy(now_.coarse, ranking);
  const std::optional<bool> by_forecasts = AddByForecasts(ranking);
  const bool is_added = by_forecasts ? *by_forecasts : AddByWholeFits(std::move(ranking));
  if (is_added) quality_.reset();
  return is_added;
}

std::optional<bool> Diagnoser::AddByForecasts(const Ranking& ranking) {
  const ForecastScreening screening(baseline_, options_);
  const std::vector<FittedModel> faults =
      ModelScreening(baseline_, options_).FitFaults(now_.coarse, ranking);
  Spend("fitting faults");
  const auto probes = HasPhysics() ? std::map<std::string, std::vector<Probe>>() : ContactProbes();
  std::optional<ForecastRound> round = screening.Run(now_.fine, faults, probes);
  Spend("forecasts");
  if (!round) return {};
  if (kept_.empty()) TellCandidates(round->ranking, ranking);
  std::vector<JudgedModel> judged = std::move(round->judged);
  Judge(round->before, &judged);
  if (judged.empty() || Stopped()) return false;
  const std::vector<JudgedModel> whole = FitWhole(judged);
  if (whole.empty()) return false;
  OrderByAllFrames(whole, &judged);
  for (const JudgedModel& one : judged) diagnosis_.models.push_back(Describe(one, round->before));
  const double share = ShareOfForecasts(round->before, judged.front().model.fine);
  if (share < options_.least_share) {
    Log(fmt::format("{} explains {:.0f} % of what forecasts leave: no explanation",
                    judged.front().candidate.summary.name, 100.0 * share));
    return false;
  }
  if (!IsBorneOut(judged.front(), whole)) return false;
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  Keep(std::move(judged), ranking);
  return true;
}

// The models of forecasts, fitted to all frames.
std::vector<JudgedModel> Diagnoser::FitWhole(const std::vector<JudgedModel>& forecasts) {
  Say("fitting all frames", 0.75);
  std::vector<std::optional<FittedScene>> fits(forecasts.size());
  ParallelFor(static_cast<int>(forecasts.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    if (!Stopped())
      fits[k] = FitBeyondForecasts(forecasts[k].model.fine, 2 * kModelIterations, runner_);
  });
  std::vector<JudgedModel> whole;
  for (std::size_t k = 0; k < fits.size(); ++k)
    if (fits[k]) whole.push_back({forecasts[k].candidate, {*fits[k], *fits[k]}});
  Judge(now_.fine, &whole);
  Spend("fitting all frames");
  return whole;
}

// Forecasts find what is missing however chaotic a motion is, but the states that they begin with
// are a little wrong: where the best model follows the recording to its end, all frames order them.
void Diagnoser::OrderByAllFrames(const std::vector<JudgedModel>& whole,
                                 std::vector<JudgedModel>* forecasts) const {
  const FittedScene& best = whole.front().model.fine;
  const bool is_lost = HasLargeResidual(best.scene, best.config, best.fit);
  if (whole.size() != forecasts->size() || is_lost) return;
  std::vector<JudgedModel> ordered;
  for (const JudgedModel& one : whole) {
    const auto same =
        std::find_if(forecasts->begin(), forecasts->end(), [&](const JudgedModel& other) {
          return other.candidate.summary.name == one.candidate.summary.name;
        });
    ordered.push_back(*same);
    ordered.back().log_evidence = one.log_evidence;
  }
  *forecasts = std::move(ordered);
}

// Both have to speak for it: forecasts begin where the recorded cloth is said to have been, which
// may be wrong alike in all of them.
bool Diagnoser::IsBorneOut(const JudgedModel& best, const std::vector<JudgedModel>& whole) const {
  const auto same = std::find_if(whole.begin(), whole.end(), [&](const JudgedModel& one) {
    return one.candidate.summary.name == best.candidate.summary.name;
  });
  return best.log_evidence >= kStrongEvidence && same != whole.end() &&
         same->log_evidence >= kStrongEvidence;
}

bool Diagnoser::AddByWholeFits(Ranking ranking) {
  const std::vector<FittedModel> models = Screen(ranking);
  if (models.empty() || Stopped()) return false;
  std::vector<JudgedModel> judged = Decide(models);
  if (judged.empty()) return false;
  Judge(now_.fine, &judged);
  if (CatchesUp(&judged)) {
    quality_.reset();
    return AddEffect();
  }
  for (const JudgedModel& one : judged) diagnosis_.models.push_back(Describe(one, now_.fine));
  if (judged.front().log_evidence < kStrongEvidence) return false;
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  Keep(std::move(judged), std::move(ranking));
  return true;
}

// Points from the config's own start: where the coarse mesh has ended may be a local minimum. What
// is far off after the first iterations explains nothing, however far it is fitted.
BothMeshes Diagnoser::FitBaselineOnBoth(const FittedScene& coarse) const {
  std::optional<FittedScene> fine = meshes_.FitFromItsOwnStart(coarse, kModelIterations);
  if (!fine) {
    std::optional<BothMeshes> both = meshes_.Refine(coarse, 2 * kModelIterations);
    return both ? std::move(*both) : BothMeshes{coarse, coarse};
  }
  const bool is_done = fine->fit.status == FitStatus::kConverged ||
                       HasLargeResidual(fine->scene, fine->config, fine->fit);
  if (!is_done && !Stopped()) {
    fine =
        Cheaper(fine, FitModel(*fine, GoOn(*fine), 2 * kModelIterations, runner_, kEnoughToDecide));
  }
  return {coarse, std::move(*fine)};
}

Diagnosis Diagnoser::Run() {
  Say("fitting the baseline", 0.0);
  const FittedScene coarse = UndoSwaps(FitBaseline(recording_, baseline_, options_));
  Spend("baseline");
  Say("baseline on the deciding mesh", 0.25);
  meshes_.Set(coarse, DecidingSide(recording_, baseline_, options_.finest_side));
  now_ = FitBaselineOnBoth(coarse);
  Spend("baseline on the deciding mesh");
  for (rounds_left_ = options_.max_effects; rounds_left_ > 0 && !Stopped(); --rounds_left_) {
    if (!AddEffect()) break;
  }
  Conclude();
  return diagnosis_;
}

Diagnosis Diagnose(const Recording& recording, const FitConfig& baseline,
                   const DiagnosisOptions& options) {
  return Diagnoser(recording, baseline, options).Run();
}

}  // namespace clothfit
