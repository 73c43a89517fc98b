// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a diagnosis. Its rounds, in each of which one effect is found, are in files of their
// own.
#include "fitting/diagnosis/pipeline/diagnose.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/classify/discrepancy_class.h"
#include "fitting/diagnosis/compare/forecast_screening.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/locate/discrepancy_pictures.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "fitting/diagnosis/rank/contradictions.h"
#include "fitting/fit/evaluation.h"
#include "tracking/outliers/swapped_markers.h"

namespace clothfit {
namespace {

constexpr int kDraws = 2;               // of mesh and step, that faults are held to
constexpr int kIterationsToBeNear = 8;  // of all frames, after windows
// Of what an even force somewhere and at some time takes: what an obstacle takes of the missing
// force to compete. Of real cloth that lay on a table, few points of which are seen, it takes a
// third to two thirds.
constexpr double kOfThePatch = 0.25;

// May the fit be somewhere else than the recorded cloth?
bool IsWorthNudging(const FittedScene& fitted) {
  return HasPoints(fitted.scene) && MayBeLocalMinimum(fitted.scene, fitted.config, fitted.fit);
}

}  // namespace

void Diagnoser::Spend(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  diagnosis_.seconds.push_back({stage, std::chrono::duration<double>(now - mark_).count()});
  mark_ = now;
}

// Nothing else can be said before.
void Diagnoser::UndoSwaps() {
  PutLabelsRight(&recording_);
  for (const SwappedMarkers& swap : recording_.put_right) {
    swaps_.push_back(ToString(swap));
    Log(swaps_.back());
  }
}

// What comes after compares forces and cameras frame by frame with where markers are.
void Diagnoser::PlaceMarkers() {
  if (!recording_.noise.layout || recording_.markers.empty() || Stopped()) return;
  const FittedScene& found = now_.coarse;
  const FreeParameters free(found.config, found.scene, MakeParameterTable());
  const std::map<int, Eigen::Vector2d> shifts =
      EvaluateScene(found.scene, found.config, free, found.fit.theta).marker_shifts;
  for (Marker& marker : recording_.markers)
    if (const auto shift = shifts.find(marker.id); shift != shifts.end())
      marker.uv += shift->second;
  recording_.noise.layout.reset();
  Log("markers are where the baseline has them on the cloth, within noise.layout");
  now_.coarse = FitBaseline(recording_, baseline_, options_);
}

// Where the cloth may be somewhere else than the recorded one, no force leads it there: then along
// the motion that is nudged to what was seen.
std::optional<LocatedForce> Diagnoser::Locate(const FittedScene& fitted, const Ranking& ranking,
                                              const DiagnosisOptions& options) const {
  if (*options.stop) return {};
  Say("locating what is missing", 0.2);
  std::optional<FittedScene> nudged;
  if (options.nudge && IsWorthNudging(fitted)) {
    nudged =
        FitNudged(WithMaterialOf(baseline_, GoOn(fitted)), kScoringDamping, FitRunner(options));
  }
  if (*options.stop) return {};
  return nudged ? LocateMissingForce(*nudged, options)
                : LocateMissingForce(fitted, options, ranking.errors.get());
}

void Diagnoser::TellLocated(const std::optional<LocatedForce>& found) {
  if (!found) {
    if (!Stopped()) Log("the missing force cannot be estimated: the simulation fails");
    return;
  }
  diagnosis_.discrepancy = found->location.discrepancy;
  Log(found->location.discrepancy.words);
  FindContacts(*found);
  if (!found->location.discrepancy.is_significant) return;
  // What is one source's has no class.
  const Scene& scene = found->fitted.scene;
  if (found->Blamed() == nullptr) {
    diagnosis_.discrepancy_class =
        ClassifyDiscrepancy(scene, found->missing, found->location).discrepancy_class;
  }
  missing_.emplace(found->missing);
  diagnosis_.discrepancy_pictures = {DrawForceMap(scene, found->missing, found->location),
                                     DrawForceArrows(scene, found->missing, found->location)};
}

void Diagnoser::FindContacts(const LocatedForce& found) {
  const Scene& scene = found.fitted.scene;
  for (ContactShape& shape : FindContactShapes(scene.mesh, scene.world.gravity, found.missing)) {
    const double share = shape.score / found.location.patch.score;
    if (share < kOfThePatch) continue;
    std::string words;
    for (const auto& [name, value] : shape.probe) words += fmt::format(" {} {:.3g}", name, value);
    Log(fmt::format("the missing force pushes as from{}: {:.2g} of what the patch takes", words,
                    share));
    contacts_.push_back(std::move(shape));
  }
}

// On the coarse mesh. Physics is ranked along forecasts, where there are any; faults of the
// observation always here.
Diagnoser::CoarseLook Diagnoser::LookOnCoarse(const FittedScene& coarse, bool is_first,
                                              const DiagnosisOptions& options) const {
  CoarseLook look;
  Say("ranking what could be missing", 0.15);
  const bool by_forecasts = CanForecast(coarse);
  const CandidateSet set = by_forecasts ? CandidateSet::kNone : CandidateSet::kCatalogue;
  RankingStart by{last_ranking_.errors, set};
  if (by_forecasts) by.draws = kDraws;
  look.ranking = RankCandidates(coarse, options, by);
  const bool is_missing = by_forecasts || look.ranking.gate_p_value < kGate;
  if (is_first && is_missing) look.located = Locate(coarse, look.ranking, options);
  if (!by_forecasts && is_missing)
    look.models = ModelScreening(baseline_, options).Run(coarse, look.ranking);
  return look;
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

// Outlines alone are held to simulated recordings of the baseline, too, on the coarse mesh. Where
// that makes as much itself, the deciding mesh may leave little all the same. A fault stands out by
// itself, where more than noise is left: the sum of what is left takes it for granted.
bool Diagnoser::IsExplained(const Ranking& ranking) const {
  if (quality_->result.misfit) return quality_->is_explained;
  const bool is_a_fault = std::any_of(
      ranking.candidates.begin(), ranking.candidates.end(),
      [](const auto& one) { return !one.faults.empty() && one.summary.is_short_listed; });
  const double left = quality_->Unexplained();
  const bool may_be_noise = left == 0.0 || (left < kTooLittle && !is_a_fault);
  return ranking.gate_p_value >= kGate && may_be_noise;
}

// The coarse mesh is looked at while the deciding one is fitted and held to its noise: a
// simulation does not fill two cores. The look ends where nothing turns out to be missing.
std::optional<Diagnoser::CoarseLook> Diagnoser::LookForMissing() {
  const bool is_first = !has_looked_;
  const FittedScene coarse = now_.coarse;
  std::atomic<bool> is_enough = false;
  DiagnosisOptions of_look = options_;
  of_look.stop = &is_enough;
  std::future<CoarseLook> looking =
      std::async(std::launch::async, [&] { return LookOnCoarse(coarse, is_first, of_look); });
  if (!is_baseline_fitted_) now_ = FitBaselineOnBoth(coarse);
  is_baseline_fitted_ = true;
  if (!Stopped() && !quality_) quality_ = AppraiseQuality(now_.fine);
  if (!Stopped() && kept_.empty()) TellOfBaseline();
  is_enough = Stopped() || quality_->is_explained;
  if (is_enough) return {};
  return looking.get();
}

bool Diagnoser::AddEffect() {
  if (HasPhysics() && forecasts_left_ < options_.least_share * forecasts_lack_) {
    Log(fmt::format("forecasts still lack {:.2g} % of what they lacked: no second effect",
                    100.0 * forecasts_left_ / forecasts_lack_));
    return false;
  }
  std::optional<CoarseLook> look = LookForMissing();
  Spend("test of fit, looking at the coarse mesh");
  if (AddContradiction()) return true;
  if (!look || Stopped()) return false;
  const bool is_first = !has_looked_;
  has_looked_ = true;
  Ranking& ranking = look->ranking;
  TakeOutWhatAgrees(contradictions_, &ranking);
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
  if (is_first) TellLocated(look->located);
  if (CanForecast(now_.fine)) {
    const std::optional<bool> is_added = AddByForecasts(ranking);
    if (is_added) return *is_added;
    ranking = RankCandidates(now_.coarse, options_, {last_ranking_.errors});
  }
  if (!look->models) {
    look->models = ModelScreening(baseline_, options_).Run(now_.coarse, ranking);
    Spend("fitting models");
  }
  return AddByWholeFits(std::move(ranking), *look->models);
}

// Points from the config's own start: where the coarse mesh has ended may be a local minimum. What
// leaves large residuals after the first iterations explains nothing, however far it is fitted.
BothMeshes Diagnoser::FitBaselineOnBoth(const FittedScene& coarse) const {
  std::optional<FittedScene> fine = meshes_.FitFromItsOwnStart(coarse, kIterationsToBeNear);
  if (!fine) {
    std::optional<BothMeshes> both = meshes_.Refine(coarse, 2 * kModelIterations);
    return both ? std::move(*both) : BothMeshes{coarse, coarse};
  }
  const bool is_done = fine->fit.status == FitStatus::kConverged ||
                       HasLargeResidual(fine->scene, fine->config, fine->fit);
  if (!is_done && !Stopped()) {
    fine = Cheaper(fine, FitModel(*fine, GoOn(*fine), 2 * kModelIterations, runner_,
                                  EnoughToDecide(fine->scene)));
  }
  return {coarse, std::move(*fine)};
}

Diagnosis Diagnoser::Run() {
  Say("fitting the baseline", 0.0);
  UndoSwaps();
  now_.coarse = FitBaseline(recording_, baseline_, options_);
  PlaceMarkers();
  now_.fine = now_.coarse;
  Spend("baseline");
  meshes_.Set(now_.coarse, DecidingSide(recording_, baseline_, options_.finest_side));
  for (rounds_left_ = options_.max_effects; rounds_left_ > 0 && !Stopped(); --rounds_left_) {
    if (!AddEffect()) break;
    if (rounds_left_ > 1) TellSoFar();
  }
  Conclude();
  return diagnosis_;
}

Diagnosis Diagnose(const Recording& recording, const FitConfig& baseline,
                   const DiagnosisOptions& options) {
  return Diagnoser(recording, baseline, options).Run();
}

}  // namespace clothfit
