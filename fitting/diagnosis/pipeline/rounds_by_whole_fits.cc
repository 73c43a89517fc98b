// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Rounds by fits of all frames, for outlines alone, to which no motion can be nudged.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "fitting/rollout/shooting_windows.h"

namespace clothfit {
namespace {

constexpr std::size_t kMostJudged = 3;  // that are fitted on the deciding mesh
constexpr double kMayWin = 0.5;         // of what the best gains on the coarse one
constexpr int kMostContinuations = 2;   // of those near the best, on the deciding mesh
constexpr double kCatchesUpFrom = 1.5;  // times the least cost: a model may come first yet
constexpr int kMostRestarts = 2;        // of a diagnosis

}  // namespace

bool Diagnoser::AddByWholeFits(Ranking ranking, const std::vector<FittedModel>& models) {
  if (models.empty() || Stopped()) return false;
  std::vector<JudgedModel> judged = Decide(models);
  if (judged.empty()) return false;
  Judge(now_.fine, &judged);
  if (CatchesUp(&judged)) {
    quality_.reset();
    return AddEffect();
  }
  DescribeAll(judged, now_.fine);
  if (judged.front().log_evidence < kStrongEvidence) return false;
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  Keep(std::move(judged), std::move(ranking));
  return true;
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

// Its effect is put on the baseline there, by windows where there are points; else it goes on from
// the baseline's material or, where that leaves large residuals since it had to stand for what was
// missing, from its own.
std::optional<BothMeshes> Diagnoser::RefineModel(const FittedModel& model) const {
  const FittedScene& fine = now_.fine;
  const bool is_one_mesh = fine.scene.mesh.grid == model.scene.scene.mesh.grid;
  if (is_one_mesh) return meshes_.Refine(model.scene, 2 * kModelIterations);
  ModelStart start = WithEffectOf(model.scene, model.candidate, fine);
  start.recording = model.scene.scene.recording;
  std::optional<FittedScene> fitted;
  if (FitsWindows(fine.scene, start.config)) {
    fitted = FitAfresh(start, Start::kWindows, 2 * kModelIterations, runner_,
                       EnoughToDecide(fine.scene));
  } else if (HasLargeResidual(fine.scene, fine.config, fine.fit)) {
    return meshes_.Refine(model.scene, 2 * kModelIterations);
  } else {
    fitted = FitModel(fine, start, 2 * kModelIterations, runner_, EnoughToDecide(fine.scene));
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
    fine = *Cheaper(fine, FitModel(fine, GoOn(fine), 2 * kModelIterations, runner_,
                                   EnoughToDecide(fine.scene)));
  });
}

bool Diagnoser::CatchesUp(std::vector<JudgedModel>* judged) {
  const JudgedModel& best = judged->front();
  if (restarts_ == kMostRestarts || Stopped() || best.log_evidence < kStrongEvidence) return false;
  Say("fitting without " + best.candidate.summary.name, 0.7);
  std::optional<FittedScene> again =
      FitModel(best.model.fine, WithoutEffect(now_.fine, best.model.fine), kModelIterations,
               runner_, EnoughToDecide(now_.fine.scene));
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

}  // namespace clothfit
