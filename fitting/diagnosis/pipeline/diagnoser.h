// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis under way: what is known so far, and its steps. Its answer is looked at in
// diagnoser_answer.cc and, on a finer mesh, in diagnoser_refine.cc; what was kept first once more
// beside a second effect in diagnoser_first.cc; all else is in diagnose.cc.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/answer/parameter_intervals.h"
#include "fitting/diagnosis/answer/verdict.h"
#include "fitting/diagnosis/compare/confidence_set.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/locate/residual_force.h"
#include "fitting/diagnosis/model/screening.h"
#include "fitting/diagnosis/rank/ranking.h"
#include "fitting/diagnosis/validate/held_out_validation.h"
#include "fitting/diagnosis/validate/model_validation.h"

namespace clothfit {

class Diagnoser {
 public:
  Diagnoser(const Recording& recording, const FitConfig& baseline, const DiagnosisOptions& options)
      : recording_(WithHeldOutFrames(recording, options.held_out_share)),
        baseline_(baseline),
        options_(options),
        runner_(options) {}

  Diagnosis Run();

 private:
  friend class DiagnoserPeer;  // of the tests
  FittedScene UndoSwaps(FittedScene fitted);
  // Ranks; where mesh and step make much of what is left, on a finer mesh.
  Ranking RankOnFineMesh(FittedScene* current, HeldOutErrors* errors);
  // A nudged fit of the baseline on its mesh: the coarser fit may have ended in a local minimum.
  std::optional<FittedScene> FitNudgedOnFineMesh(const FittedScene& fitted);
  // Where, when and of what class a force is missing.
  void LocateDiscrepancy(const FittedScene& fitted, const Ranking& ranking);
  // The model of `fitted` nudged to what was seen, from the material parameters that the baseline
  // was given; null where that cannot be or would be of no use. Fitted once for one fit.
  const FittedScene* Nudged(const FittedScene& fitted, const Ranking& ranking);
  // One more effect. False where there is none to be had.
  bool AddEffect(FittedScene* current, HeldOutErrors* errors);
  // Whether a fit without the effect, begun where the model has ended, comes (nearly) as far: then
  // the model had found a better local minimum, not an effect. That fit becomes the one that the
  // gain of models is measured from.
  bool CatchesUp(const FittedModel& model, FittedScene* current, HeldOutErrors* errors);
  // Backward elimination: drops the first physical effect where the second explains nearly as much
  // without it. Else fits effects that match the force of the first beside the second, and takes
  // the one that comes first.
  void LookBackAtFirst(FittedScene* current, HeldOutErrors* errors);
  // Validates on the held-out frames; if that fails and the model costs at most kFarLess of
  // `other_cost`, by the other tests as well.
  HeldOutValidation Validate(const FittedModel& model, double other_cost,
                             const ValidationStart& start) const;
  // Forgets a round, so that it can be held again from a better fit.
  void BeginAgain(std::size_t first_model, const FittedScene& better, const HeldOutErrors& errors);
  void FitAgainWithoutFault(FittedScene* current, HeldOutErrors* errors);
  Model Describe(const FittedModel& model, const FittedScene& before, const HeldOutErrors& errors);
  // Of the model at `index` of diagnosis_.models, whose validation it replaces.
  void ValidateOtherwiseToo(const FittedModel& model, std::size_t index,
                            const ValidationStart& start);
  void TellApart(const ConfidenceSet& confidence_set);
  void KeepCompetitors(const std::vector<FittedModel>& models, std::size_t winner);
  // A law instead of names, where those explain too little and it explains more.
  void LearnInstead(FittedScene* current);
  // The answer without those of its amounts that may be anything about nothing.
  void TakeOutUndetermined(FittedScene* current, const HeldOutErrors& errors);
  // What mesh and step do to the answer: to its parameters, and what they leave of it.
  void MeasureAnswer(const FittedScene& model);
  void WithdrawWhatMayBeNothing(FittedScene* current);
  // What was kept last is not any more.
  void TakeBack(FittedScene* current);
  // The answer and what it is held against on a finer mesh, where a fit may use one; taken back
  // where it does not stand there.
  void RefineAnswer(FittedScene* current, HeldOutErrors* errors);
  bool MayRefine(const ClothMesh& mesh) const;
  // Each gone on with on that mesh; empty where it fails.
  std::vector<std::optional<FittedScene>> FitOn(
      const std::array<int, 2>& grid, const std::vector<const FittedScene*>& coarse) const;
  FittedScene GoneOnWith(FittedScene fitted) const;
  // Each from the material parameters of the answer, too, on whose mesh they are.
  void FitWithMaterialOf(const FittedScene& answer, std::vector<FittedModel>* competitors) const;
  // Of the answer and its competitors, all on the finer mesh, the one that comes first there.
  void ChooseAgain(std::vector<FittedModel> competitors, FittedScene* current,
                   HeldOutErrors* errors);
  // Its amounts, cost and validation, and what mesh and step do to it, on the mesh that it is on
  // now.
  void DescribeAnswerAgain(const FittedScene& current, const HeldOutErrors& errors);
  // The answer among the models; null where it was fitted on another mesh than they.
  Model* AnswerAmongModels();
  // Share of what the baseline does not explain that the answer does.
  double ExplainedBy(const FittedScene& model) const;
  void WidenIntervals(const FittedScene& model);
  // Where, when and how the physics that was named acts.
  void MeasureWhatActs(const FittedScene& model);
  void Conclude(const FittedScene& current);
  void Say(const std::string& stage, double fraction) {
    if (options_.progress) options_.progress(stage, fraction);
  }
  void Log(const std::string& line) const {
    if (options_.log) options_.log(line);
  }
  bool Stopped() const { return runner_.IsStopped(); }
  ChoiceRules RulesOf(const FittedScene& before) const {
    return {before.fit.cost_after, options_.least_share, options_.validate};
  }
  void Spend(const std::string& stage);
  void SpendOn(const Ranking& ranking);

  Recording recording_;
  FitConfig baseline_;
  const DiagnosisOptions& options_;
  FitRunner runner_;
  Diagnosis diagnosis_;
  Ranking last_ranking_;
  std::vector<std::string> kept_parameters_;
  // What was kept last, and what it was held against.
  struct Kept {
    std::size_t model;  // of diagnosis_.models
    RankedCandidate candidate;
    FittedScene before;
    HeldOutErrors before_errors;
  };
  std::optional<Kept> kept_;
  // The first physics that was kept, alone so far, with the round that it was found in.
  struct First {
    Kept kept;
    Ranking ranking;
    std::vector<FittedModel> models;
    std::vector<std::string> effects, parameters;  // that were kept before
  };
  // What was kept last without it. Empty where the fit fails.
  std::optional<FittedModel> WithoutFirst(const First& first, const FittedScene& current);
  // Does the second alone explain nearly as much as `current`, which has both, and is it validated?
  bool IsIdle(const First& first, const FittedModel& second, const FittedScene& current);
  void DropFirst(First first, FittedModel second, FittedScene* current, HeldOutErrors* errors);
  void ExchangeFirst(const First& first, const FittedModel& second, FittedScene* current,
                     HeldOutErrors* errors);
  // Takes the competitor in its place, which has the second besides, where both are validated.
  bool TakesFirstPlace(const First& first, const FittedModel& second, const FittedModel& competitor,
                       FittedScene* current, HeldOutErrors* errors);
  // Of models that all have the second effect besides.
  void TellApartBeside(const First& first, const FittedModel& second,
                       const std::vector<FittedModel>& models, std::size_t winner);
  void Keep(const FittedModel& model, FittedScene before, HeldOutErrors before_errors);
  // One of diagnosis_.models.
  void TakeForAnswer(Kept kept);
  // It and what was kept last.
  void ForgetFirst(const First& first);
  std::optional<First> first_kept_;
  int rounds_left_ = 0;
  std::vector<FittedModel>
      competitors_;          // physics that was fitted and cannot be told from the first
  double kept_score_ = 0.0;  // the highest of what was kept
  double baseline_cost_ = 0.0;
  bool is_above_discretisation_ = false;
  std::optional<FittedScene> first_scene_;  // the baseline that was ranked first
  std::optional<Ranking> first_ranking_;
  HeldOutErrors first_errors_;
  int restarts_ = 0;
  double first_unexplained_ = 0.0;  // sum of squares
  DiscretisationShifts shifts_;     // of the answer
  // What the answer explained on the mesh on which it was found, where it was refined.
  std::optional<double> explained_;
  std::optional<MissingForce> missing_;
  // Of the fit that is looked at now, once it has been asked for: its nudged motion, where that can
  // be simulated.
  std::optional<std::optional<FittedScene>> nudged_;
  std::chrono::steady_clock::time_point mark_ = std::chrono::steady_clock::now();
};

}  // namespace clothfit
