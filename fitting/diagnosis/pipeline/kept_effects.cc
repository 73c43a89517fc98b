// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What was kept so far, what a new effect does to it, and how it is described.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/names.h"
#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/answer/parameter_intervals.h"
#include "fitting/diagnosis/compare/forecast_screening.h"
#include "fitting/diagnosis/compare/separating_motion.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "fitting/diagnosis/validate/model_validation.h"

namespace clothfit {
namespace {

// Those that the recording does not strongly speak against, beside the best, which comes first.
std::vector<const JudgedModel*> ConfidenceSetOf(const std::vector<JudgedModel>& judged) {
  std::vector<const JudgedModel*> set;
  for (const JudgedModel& one : judged)
    if (one.log_evidence >= judged.front().log_evidence - kStrongEvidence) set.push_back(&one);
  return set;
}

}  // namespace

void Diagnoser::Judge(const FittedScene& before, std::vector<JudgedModel>* judged) const {
  JudgeModels(before, judged);
  for (const JudgedModel& one : *judged) {
    Log(fmt::format("with {}: cost {:.6g} -> {:.6g} on {} particles, log evidence {:.4g}",
                    one.candidate.summary.name, before.fit.cost_after, one.model.Cost(),
                    one.model.fine.scene.mesh.num_particles(), one.log_evidence));
  }
}

void Diagnoser::Keep(std::vector<JudgedModel> judged, Ranking ranking) {
  const bool is_physics = judged.front().candidate.faults.empty();
  const bool is_first = !HasPhysics();
  if (is_first) TellApart(judged);
  BothMeshes before = std::move(now_);
  now_ = judged.front().model;
  quality_.reset();
  RankedCandidate candidate = judged.front().candidate;
  kept_.push_back({std::move(candidate), std::move(before), std::move(ranking), std::move(judged)});
  if (is_physics && !is_first) LookBack();
  if (now_.fine.of_forecasts) {
    GoOnBeyondForecasts();
  } else if (!is_physics) {
    FitAgainWithoutFault();
  }
  if (!is_physics) PutFaultFirst();
}

std::vector<Diagnoser::Kept>::iterator Diagnoser::FirstPhysics() {
  return std::find_if(kept_.begin(), kept_.end(),
                      [](const Kept& kept) { return kept.IsPhysics(); });
}

// A fault that was found beside physics was there without it, too: what physics explains is told
// of recordings that are put right.
void Diagnoser::PutFaultFirst() {
  const auto first = FirstPhysics();
  if (first == kept_.end()) return;
  Say("fitting without the fault", 0.7);
  const auto put_right = [&](const FittedScene& before) {
    ModelStart start = GoOn(before);
    start.recording = now_.fine.scene.recording;
    return start;
  };
  BothMeshes with_fault = first->before;
  const ModelStart without_physics = put_right(with_fault.fine);
  for (auto kept = first; kept + 1 != kept_.end(); ++kept) {
    const std::optional<FittedScene> again =
        FitModel(kept->before.fine, put_right(kept->before.fine), 2 * kModelIterations, runner_,
                 EnoughToDecide(now_.fine.scene));
    std::optional<BothMeshes> both = again ? OnBoth(*again) : std::nullopt;
    if (both) kept->before = *std::move(both);
  }
  kept_.back().before = std::move(with_fault);
  if (forecasts_lack_ > 0.0) {
    const std::optional<FittedScene> forecasts = FitToForecasts(
        without_physics, now_.fine.scene.mesh.grid, {1}, runner_, &first->before.fine);
    if (forecasts) forecasts_lack_ = LeftByForecasts(*forecasts);
  }
  std::rotate(first, kept_.end() - 1, kept_.end());
  Spend("fitting without the fault");
}

// Backward elimination: a stiff patch that was kept for a stiff seam has nothing left to stand for
// once the seam has been found. Exchange: wind and a heavy patch look like a tilted gravity while
// the patch is not known, and like nothing but wind beside it.
void Diagnoser::LookBack() {
  if (Stopped()) return;
  const auto first_physics = FirstPhysics();
  const auto first = static_cast<std::size_t>(first_physics - kept_.begin());
  const RankedCandidate second = kept_.back().candidate;
  const BothMeshes& before = first_physics->before;
  Say("fitting without " + first_physics->candidate.summary.name, 0.7);
  std::optional<FittedScene> alone =
      FitLike(now_.fine, WithOnly(before.fine, now_.fine, second), 2 * kModelIterations);
  Spend("fitting without what was found");
  if (!alone) return;
  std::vector<JudgedModel> both = {{first_physics->candidate, now_}};
  for (const JudgedModel& competitor : first_physics->competitors) {
    const bool is_other =
        competitor.candidate.summary.name != first_physics->candidate.summary.name &&
        competitor.candidate.summary.name != second.summary.name;
    if (!is_other || !competitor.candidate.faults.empty() || Stopped()) continue;
    std::optional<FittedScene> beside =
        FitLike(competitor.model.fine, WithEffectOf(now_.fine, second, competitor.model.fine),
                kModelIterations);
    if (beside)
      both.push_back({competitor.candidate, {competitor.model.coarse, std::move(*beside)}});
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

// What is of forecasts will be gone on with to all frames, and comes to the coarse mesh then.
std::optional<BothMeshes> Diagnoser::OnBoth(const FittedScene& fine) const {
  if (fine.of_forecasts) return BothMeshes{fine, fine};
  return meshes_.Coarsen(fine, kModelIterations);
}

std::optional<FittedScene> Diagnoser::FitLike(const FittedScene& other, const ModelStart& start,
                                              int most_iterations) const {
  if (!other.of_forecasts) return FitModel(other, start, most_iterations, runner_);
  return FitToForecasts(start, other.scene.mesh.grid, {1}, runner_, &other);
}

void Diagnoser::TellApart(const std::vector<JudgedModel>& judged) {
  diagnosis_.confidence_set.clear();
  diagnosis_.separating.reset();
  std::vector<const FittedScene*> fitted;
  for (const JudgedModel* const one : ConfidenceSetOf(judged)) {
    diagnosis_.confidence_set.push_back(one->candidate.summary.name);
    // What is put right in the observation moves no cloth.
    if (one->candidate.faults.empty()) fitted.push_back(&one->model.fine);
  }
  if (fitted.size() < 2) return;
  diagnosis_.separating = FindSeparatingMotion(fitted);
  Spend("separating motion");
}

void Diagnoser::TellSetsBeside() {
  diagnosis_.sets_beside.clear();
  const auto first = FirstPhysics();
  if (first == kept_.end()) return;
  for (auto kept = first + 1; kept != kept_.end(); ++kept) {
    if (!kept->IsPhysics()) continue;
    std::vector<std::string> names;
    for (const JudgedModel* const one : ConfidenceSetOf(kept->competitors))
      names.push_back(one->candidate.summary.name);
    if (names.size() > 1) diagnosis_.sets_beside.push_back(std::move(names));
  }
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
  described.explained =
      fine.of_forecasts ? ShareOfForecasts(before, fine) : Explained(WithoutPhysics(), fine);
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

void Diagnoser::DescribeAll(const std::vector<JudgedModel>& judged, const FittedScene& before) {
  const std::size_t first = diagnosis_.models.size();
  diagnosis_.models.resize(first + judged.size());
  ParallelFor(static_cast<int>(judged.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    diagnosis_.models[first + k] = Describe(judged[k], before);
  });
}

HeldOutValidation Diagnoser::ValidateOn(const FittedScene& model, const FittedScene& before,
                                        const RankedCandidate& candidate,
                                        const Ranking& ranking) const {
  // What mesh and step do to a prediction is held against physics, not against a camera.
  const double by_mesh = candidate.faults.empty() ? last_ranking_.PredictionError() : 0.0;
  return ValidateOnHeldOut(model, before, FaultySource(candidate, ranking), by_mesh, options_.seed);
}

bool Diagnoser::PredictsWorse(const JudgedModel& model) const {
  if (!model.candidate.faults.empty()) return false;
  const HeldOutValidation predicted =
      ValidateOn(model.model.fine, now_.fine, model.candidate, last_ranking_);
  if (predicted.after <= predicted.before) return false;
  Log(fmt::format("{} is not kept: held-out frames are predicted worse with it, {:.3g} times",
                  model.candidate.summary.name, predicted.after / predicted.before));
  return true;
}

std::vector<std::string> Diagnoser::EffectsSoFar() const {
  std::vector<std::string> effects = swaps_;
  for (const Kept& kept : kept_) {
    for (const std::string& effect : kept.candidate.Effects()) {
      // A fault may be put right once more.
      if (!IsAmong(effects, effect)) effects.push_back(effect);
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

bool Diagnoser::HasPhysics() const {
  return std::any_of(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.IsPhysics(); });
}

}  // namespace clothfit
