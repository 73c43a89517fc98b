// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a diagnosis, one after the other.
#include "fitting/diagnosis/pipeline/diagnose.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/classify/discrepancy_class.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/locate/discrepancy_pictures.h"
#include "fitting/diagnosis/locate/locate_missing_force.h"
#include "fitting/diagnosis/model/explained_share.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "fitting/diagnosis/rank/nudged_ranking.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr int kCoarsestSide = 9;     // on coarser meshes amounts come out a tenth wrong
constexpr double kFineEnough = 0.7;  // share of the unexplained that the mesh may make
constexpr double kCatchesUp = 0.3;   // of what a model gains, the same without its effect
constexpr int kMostRestarts = 2;     // of a diagnosis

// Would anything be held against the physics?
bool IsSuspicious(const Ranking& ranking) {
  return ranking.gate_p_value < kGate ||
         std::any_of(
             ranking.candidates.begin(), ranking.candidates.end(), [](const RankedCandidate& c) {
               return c.summary.is_short_listed && c.summary.kind == CandidateKind::kPhysics;
             });
}

// Does one candidate stand so far out that an error of the mesh cannot be mistaken for it?
bool IsObvious(const Ranking& ranking) {
  constexpr double kFarOut = 3.0;  // detection limits
  return std::any_of(
      ranking.candidates.begin(), ranking.candidates.end(), [&](const RankedCandidate& c) {
        return c.summary.is_short_listed && c.summary.share >= 0.5 && c.Exceeds(kFarOut);
      });
}

// May the fit be somewhere else than the recorded cloth? (Beyond any mesh, what is ordinary comes
// first.)
bool IsWorthNudging(const FittedScene& fitted, const Ranking& ranking) {
  return HasPoints(fitted.scene) && ranking.residual_rms < kUnusableResidual &&
         MayBeLocalMinimum(fitted.scene, fitted.config, fitted.fit);
}

// Does a force lead the simulation to the recording, and is it known which way it points?
bool Tells(const LocatedForce& found) {
  constexpr double kFollows = 0.5;  // share of the sum of squares
  const Discrepancy& m = found.location.discrepancy;
  return found.missing.explained >= kFollows && (!m.is_significant || m.peak > m.peak_sigma);
}

// Do mesh and step make much of what is left?
bool MeshMatters(const Ranking& ranking) {
  const double left = std::sqrt(ranking.unexplained / std::max(1, ranking.num_rows));
  return ranking.discretisation_rms > kFineEnough * left;
}

// 0 where the mesh may be made finer already, or makes less than noise.
int SideThatShowsMore(const ClothMesh& mesh, const Ranking& ranking, int finest_side) {
  const int side = std::max(mesh.grid[0], mesh.grid[1]);
  const bool is_finest = mesh.is_grid() && side >= finest_side;
  return is_finest && ranking.discretisation_rms > 1.0 ? FinerSide(side) : 0;
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
    diagnosis_.effects.push_back(name);
    fitted = std::move(*again);
  }
  return fitted;
}

bool Diagnoser::CatchesUp(const FittedModel& model, FittedScene* current, HeldOutErrors* errors) {
  if (restarts_ == kMostRestarts || Stopped()) return false;
  Say("fitting without " + model.candidate.summary.name, 0.7);
  std::optional<FittedScene> again =
      FitModel(model.scene, WithoutEffect(*current, model.scene), 2 * kModelIterations, runner_);
  Spend("fitting without what was found");
  if (!again) return false;
  const double before = current->fit.cost_after, after = again->fit.cost_after;
  Log(fmt::format("without {}, from where it ended: cost {:.6g} -> {:.6g}",
                  model.candidate.summary.name, before, after));
  if (before - after < kCatchesUp * (before - model.scene.fit.cost_after)) return false;
  ++restarts_;
  *current = std::move(*again);
  *errors = MeasureHeldOut(*current);
  return true;
}

void Diagnoser::BeginAgain(std::size_t first_model, const FittedScene& better,
                           const HeldOutErrors& errors) {
  diagnosis_.models.resize(first_model);
  if (kept_) {  // its fit has become a better one; the baseline is what it was
    diagnosis_.answer =
        Describe({kept_->candidate, better, errors}, kept_->before, kept_->before_errors);
    diagnosis_.answer->is_kept = true;
    diagnosis_.models[kept_->model] = *diagnosis_.answer;
    return;
  }
  baseline_cost_ = better.fit.cost_after;
  diagnosis_.baseline = better.config;
  diagnosis_.baseline_fit = better.fit;
  diagnosis_.ranking.clear();
  diagnosis_.discrepancy.reset();
  diagnosis_.discrepancy_class.reset();
  diagnosis_.discrepancy_pictures.reset();
  missing_.reset();
}

Model Diagnoser::Describe(const FittedModel& model, const FittedScene& before,
                          const HeldOutErrors& errors) {
  Model described;
  described.effects = diagnosis_.effects;
  for (const std::string& newest : model.candidate.Effects()) {
    const bool is_again =  // a fault that is put right once more
        std::find(described.effects.begin(), described.effects.end(), newest) !=
        described.effects.end();
    if (!is_again) described.effects.push_back(newest);
  }
  described.config = model.scene.values;
  described.cost = model.scene.fit.cost_after;
  const bool is_fault = !model.candidate.faults.empty();  // held to no share of the whole
  const double score = model.candidate.summary.score;
  const double explainable = is_fault ? score : std::max(score, last_ranking_.explainable);
  described.explained = ShareExplained(before.fit.cost_after, described.cost,
                                       0.5 * last_ranking_.null_mean, 0.5 * explainable);
  std::vector<std::string> names = kept_parameters_;
  if (model.candidate.faults.empty()) {
    names.insert(names.end(), model.candidate.names.begin(), model.candidate.names.end());
    for (const auto& [name, value] : model.candidate.probe) names.push_back(name);
  } else {
    described.parameters = model.candidate.summary.parameters;
  }
  const std::vector<EffectParameter> estimates = EstimatesOf(model.scene, names);
  described.parameters.insert(described.parameters.end(), estimates.begin(), estimates.end());
  described.validation = ValidateOnHeldOut(model, {before, errors, last_ranking_, options_});
  return described;
}

// Where the best of a round is worth it and not validated, the held-out frames may not be able to
// tell.
void Diagnoser::ValidateOtherwiseToo(const FittedModel& model, std::size_t index,
                                     const ValidationStart& start) {
  if (Stopped()) return;
  const std::optional<HeldOutValidation> validation = ValidateOtherwise(model, start);
  Spend("proof by other means");
  if (validation) diagnosis_.models[index].validation = *validation;
}

void Diagnoser::KeepCompetitors(const std::vector<FittedModel>& models, std::size_t winner) {
  competitors_.clear();
  for (std::size_t i = 0; i < models.size(); ++i) {
    const RankedCandidate& candidate = models[i].candidate;
    const std::vector<std::string>& set = diagnosis_.confidence_set;
    const bool is_in = std::find(set.begin(), set.end(), candidate.summary.name) != set.end();
    if (i != winner && is_in && candidate.faults.empty()) competitors_.push_back(models[i]);
  }
}

// What else it could be, and what to record to know.
void Diagnoser::TellApart(const ConfidenceSet& confidence_set) {
  diagnosis_.confidence_set = confidence_set.names;
  if (confidence_set.fitted.empty()) return;
  diagnosis_.separating = FindSeparatingMotion(confidence_set.fitted);
  Spend("separating motion");
}

std::optional<FittedScene> Diagnoser::FitNudgedOnFineMesh(const FittedScene& fitted) {
  Say("baseline, nudged on a finer mesh", 0.27);
  const ModelStart start = WithMaterialOf(baseline_, GoOn(fitted));
  std::optional<FittedScene> nudged =
      FitAfresh(start, Start::kNudged, baseline_.max_iterations, runner_);
  if (!nudged) return {};
  Log(fmt::format("nudged on that mesh: cost {:.6g} where {:.6g} was come to",
                  nudged->fit.cost_after, fitted.fit.cost_after));
  nudged->config = fitted.config;  // it begins where it is told to, not where this one did
  return nudged;
}

Ranking Diagnoser::RankOnFineMesh(FittedScene* current, HeldOutErrors* errors) {
  for (;;) {
    std::array<int, 2> grid = current->scene.mesh.grid;
    const bool can_be_finer =
        current->scene.mesh.is_grid() && std::max(grid[0], grid[1]) < options_.finest_side;
    RankingStart start;
    // Far off, it will be ranked again on a finer mesh, or a candidate is obvious.
    if (can_be_finer && HasLargeResidual(current->scene, current->config, current->fit))
      start.draws = 1;
    Ranking ranking = RankCandidates(*current, options_, start);
    SpendOn(ranking);
    Log(fmt::format("residuals of {:.3g} sigmas, mesh and step leave {:.3g}; p = {:.2g}",
                    ranking.residual_rms, ranking.discretisation_rms, ranking.gate_p_value));
    if (ranking.errors->num_elsewhere > 0) {
      Log(fmt::format(
          "{} of the simulations with other steps or meshes go elsewhere altogether, and "
          "are left out of the null",
          ranking.errors->num_elsewhere));
    }
    const double off = ranking.residual_rms;
    const bool may_be_mesh =
        off < kUnusableResidual && (MeshMatters(ranking) || off > kLargeResidual);
    const bool is_coarse = std::max(grid[0], grid[1]) < kCoarsestSide;
    const bool may_be_all = ranking.gate_p_value >= kGate;  // of what is left
    const bool is_worth_it = is_coarse || (may_be_mesh && (may_be_all || !IsObvious(ranking)));
    // A floor above all that is left says that the mesh is too coarse to tell. (Who tells fewer
    // particles than any answer needs wants it quick.)
    const bool tells_nothing = !is_coarse && ranking.discretisation_rms > ranking.residual_rms;
    const bool is_open =
        IsSuspicious(ranking) || ranking.residual_rms > kLargeResidual || tells_nothing;
    if (!is_worth_it || !is_open || !can_be_finer || Stopped()) return ranking;
    ModelStart finer = GoOn(*current);
    for (int& n : grid) n = std::min(options_.finest_side, FinerSide(n));
    finer.config.resolution = grid;
    Log(fmt::format("the mesh matters: {} x {} particles", grid[0], grid[1]));
    Say(fmt::format("baseline, {} x {} particles", grid[0], grid[1]), 0.25);
    std::optional<FittedScene> refined =
        FitModel(*current, finer, baseline_.max_iterations, runner_);
    if (refined && MayBeLocalMinimum(refined->scene, refined->config, refined->fit) && !Stopped()) {
      std::optional<FittedScene> nudged = FitNudgedOnFineMesh(*refined);
      refined = Cheaper(std::move(refined), std::move(nudged));
    }
    if (!refined) return ranking;
    *current = std::move(*refined);
    Spend("baseline on a finer mesh");
    *errors = MeasureHeldOut(*current);
    baseline_cost_ = current->fit.cost_after;
    diagnosis_.baseline = current->config;
    diagnosis_.baseline_fit = current->fit;
  }
}

const FittedScene* Diagnoser::Nudged(const FittedScene& fitted, const Ranking& ranking) {
  if (!options_.nudge || !IsWorthNudging(fitted, ranking) || Stopped()) return nullptr;
  if (!nudged_) {
    nudged_.emplace(FitNudged(WithMaterialOf(baseline_, GoOn(fitted)), kScoringDamping, runner_));
    Spend("nudged motion");
  }
  return *nudged_ ? &**nudged_ : nullptr;
}

// A simulation that a force cannot lead to the recorded motion, as it is somewhere else altogether,
// tells little about that force: then along the motion that is nudged to what was seen.
void Diagnoser::LocateDiscrepancy(const FittedScene& fitted, const Ranking& ranking) {
  if (Stopped()) return;
  Say("locating what is missing", 0.4);
  std::optional<LocatedForce> found = LocateMissingForce(fitted, options_, ranking.errors.get());
  Spend("locating");
  if (!found || !Tells(*found)) {
    if (const FittedScene* const held = Nudged(fitted, ranking)) {
      Log(fmt::format(
          "a force of {:.2g} N/m^2 explains {:.0f} % of this: located along a nudged motion",
          found ? found->location.discrepancy.peak : 0.0,
          found ? 100.0 * found->missing.explained : 0.0));
      std::optional<LocatedForce> nudged = LocateMissingForce(*held, options_);
      if (nudged) found = std::move(nudged);
      Spend("locating");
    }
  }
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
  diagnosis_.discrepancy_pictures = {DrawForceMap(scene, found->missing, found->location),
                                     DrawForceArrows(scene, found->missing, found->location)};
}

// A baseline that had to follow a wrong camera may be in a local minimum, and begins anew.
void Diagnoser::FitAgainWithoutFault(FittedScene* current, HeldOutErrors* errors) {
  if (Stopped() || !HasLargeResidual(current->scene, current->config, current->fit)) return;
  FitConfig baseline = baseline_;
  baseline.resolution = current->config.resolution;
  for (const std::string& name : kept_parameters_) {
    const auto kept = current->config.parameters.find(name);
    if (kept != current->config.parameters.end()) baseline.parameters[name] = kept->second;
  }
  FittedScene again = FitBaseline(current->scene.recording, baseline, options_);
  Log(fmt::format("without the fault, begun anew: cost {:.6g} -> {:.6g}", current->fit.cost_after,
                  again.fit.cost_after));
  Spend("baseline without the fault");
  if (!(again.fit.cost_after < current->fit.cost_after)) return;
  *current = std::move(again);
  *errors = MeasureHeldOut(*current);
}

void Diagnoser::TakeForAnswer(Kept kept) {
  Model& model = diagnosis_.models[kept.model];
  model.is_kept = true;
  diagnosis_.answer = model;
  diagnosis_.effects = model.effects;
  for (const EffectParameter& p : model.parameters) kept_parameters_.push_back(p.name);
  kept_ = std::move(kept);
}

bool Diagnoser::AddEffect(FittedScene* current, HeldOutErrors* errors) {
  Say("ranking what could be missing", 0.3);
  nudged_.reset();
  const bool is_first = diagnosis_.ranking.empty();
  Ranking ranking = is_first ? RankOnFineMesh(current, errors)
                             : RankCandidates(*current, options_, {last_ranking_.errors});
  if (!is_first) SpendOn(ranking);
  if (is_first) {
    diagnosis_.gate_p_value = ranking.gate_p_value;
    diagnosis_.left_rms = ranking.left_rms;
    diagnosis_.null_left_rms = ranking.null_left_rms;
    diagnosis_.residual_rms = ranking.residual_rms;
    diagnosis_.discretisation_rms = ranking.discretisation_rms;
    diagnosis_.promised = ranking.promised;
    diagnosis_.finer_side = SideThatShowsMore(current->scene.mesh, ranking, options_.finest_side);
    first_unexplained_ = ranking.unexplained;
    is_above_discretisation_ = !MeshMatters(ranking);
    first_scene_ = *current;
    first_ranking_ = ranking;
    first_errors_ = *errors;
  }
  last_ranking_ = ranking;
  if (is_first && IsSuspicious(ranking)) LocateDiscrepancy(*current, ranking);
  ModelScreening::RankAlongNudged nudge;
  if (options_.nudge && IsWorthNudging(*current, ranking)) {
    nudge = [&](Ranking* open) {
      Spend("fitting models");
      Say("ranking along a nudged motion", 0.6);
      if (const FittedScene* const held = Nudged(*current, ranking))
        RankNudged(*held, options_, open);
      Spend("ranking along a nudged motion");
    };
  }
  const ModelScreening race(baseline_, options_);
  std::vector<FittedModel> models =
      race.Run(*current, *errors, options_.least_share * first_unexplained_, nudge, &ranking);
  Spend("fitting models");
  if (is_first) {
    for (const RankedCandidate& candidate : ranking.candidates)
      diagnosis_.ranking.push_back(candidate.summary);
  }
  if (models.empty()) return false;
  const std::size_t first_model = diagnosis_.models.size();
  for (const FittedModel& model : models)
    diagnosis_.models.push_back(Describe(model, *current, *errors));
  const ChoiceRules rules = RulesOf(*current);
  if (FirstDeservesAnotherTest(diagnosis_.models, first_model, rules))
    ValidateOtherwiseToo(models.front(), first_model, {*current, *errors, ranking, options_});
  const std::optional<Choice> choice = ChooseModel(diagnosis_.models, first_model, rules);
  if (!choice) return false;
  FittedModel& model = models[choice->model - first_model];
  // Before a validation by other means, which takes many fits.
  if (CatchesUp(model, current, errors)) {
    BeginAgain(first_model, *current, *errors);
    return AddEffect(current, errors);
  }
  if (!choice->is_kept) {
    ValidateOtherwiseToo(model, choice->model, {*current, *errors, ranking, options_});
    if (!ChooseModel(diagnosis_.models, first_model, rules)->is_kept) return false;
  }
  if (!diagnosis_.answer) {
    const std::size_t winner = choice->model - first_model;
    TellApart(FindConfidenceSet(ranking, models, winner, current->fit.cost_after));
    KeepCompetitors(models, winner);
  }
  const bool is_physics = model.candidate.faults.empty();
  const bool is_first_physics = is_physics && (!kept_ || !kept_->candidate.faults.empty());
  if (is_first_physics) {
    first_kept_ = {{choice->model, model.candidate, *current, *errors},
                   ranking,
                   models,
                   diagnosis_.effects,
                   kept_parameters_};
  }
  kept_score_ = std::max(kept_score_, model.candidate.summary.score);
  TakeForAnswer({choice->model, model.candidate, std::move(*current), std::move(*errors)});
  *errors = std::move(model.errors);
  *current = std::move(model.scene);
  if (!is_physics) FitAgainWithoutFault(current, errors);
  if (is_physics && !is_first_physics) LookBackAtFirst(current, errors);
  return true;
}

Diagnosis Diagnoser::Run() {
  Say("fitting the baseline", 0.0);
  FittedScene fitted = FitBaseline(recording_, baseline_, options_);
  diagnosis_.baseline = fitted.config;
  diagnosis_.baseline_fit = fitted.fit;
  FittedScene current = UndoSwaps(std::move(fitted));
  baseline_cost_ = current.fit.cost_after;
  Spend("baseline");
  HeldOutErrors errors = MeasureHeldOut(current);
  for (rounds_left_ = options_.max_effects; rounds_left_ > 0 && !Stopped(); --rounds_left_) {
    if (!AddEffect(&current, &errors)) break;
  }
  MeasureAnswer(current);
  WithdrawWhatMayBeNothing(&current);
  LearnInstead(&current);
  RefineAnswer(&current, &errors);
  WidenIntervals(current);
  TakeOutUndetermined(&current, errors);
  const ClothMesh& mesh = current.scene.mesh;
  diagnosis_.motions.resolution = mesh.grid;
  if (first_scene_) diagnosis_.motions.baseline = SimulateFitted(*first_scene_);
  if (missing_) diagnosis_.motions.missing_force = ForceOnParticles(mesh, *missing_);
  diagnosis_.motions.held_out = recording_.splits.held_out_frames;
  if (diagnosis_.answer || !diagnosis_.effects.empty())
    diagnosis_.motions.answer = SimulateFitted(current);
  Conclude(current);
  return diagnosis_;
}

Diagnosis Diagnose(const Recording& recording, const FitConfig& baseline,
                   const DiagnosisOptions& options) {
  return Diagnoser(recording, baseline, options).Run();
}

}  // namespace clothfit
