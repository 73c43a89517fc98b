// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis under way: what is known so far, and its steps. Effects are found one after the
// other, in rounds by forecasts or by whole fits; diagnoser_answer.cc has what is made of them.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/answer/verdict.h"
#include "fitting/diagnosis/compare/two_meshes.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/locate/contact_shapes.h"
#include "fitting/diagnosis/locate/locate_missing_force.h"
#include "fitting/diagnosis/locate/residual_force.h"
#include "fitting/diagnosis/model/screening.h"
#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

class Diagnoser {
  friend class DiagnoserPeer;  // of tests: steps in states that few recordings bring about

 public:
  Diagnoser(const Recording& recording, const FitConfig& baseline, const DiagnosisOptions& options)
      : recording_(WithHeldOutFrames(recording, options.held_out_share)),
        baseline_(baseline),
        options_(options),
        runner_(options),
        meshes_(runner_) {}

  Diagnosis Run();

 private:
  // An effect, or a fault put right, with what it was held against.
  struct Kept {
    RankedCandidate candidate;
    BothMeshes before;
    Ranking ranking;                       // of what was missing before
    std::vector<JudgedModel> competitors;  // all that were fitted in that round, itself among them
    bool IsPhysics() const { return candidate.faults.empty(); }
  };

  void UndoSwaps();
  void PlaceMarkers();
  BothMeshes FitBaselineOnBoth(const FittedScene& coarse) const;
  // A model of the coarse mesh on the deciding one.
  std::optional<BothMeshes> RefineModel(const FittedModel& model) const;
  // One more effect. False where there is none to be had.
  bool AddEffect();
  void TellOfBaseline();
  void TellOfNull(const Ranking& ranking);
  void TellCandidates(const Ranking& of_physics, const Ranking& of_faults);
  bool IsExplained(const Ranking& ranking) const;
  // What the coarse mesh tells: faults, ranked, and where a force is missing.
  struct CoarseLook {
    Ranking ranking;
    std::optional<LocatedForce> located;  // of the first round
    // Where whole fits decide and something is missing: fitted with what it may be.
    std::optional<std::vector<FittedModel>> models;
  };
  // options: a look's own, with what stops it.
  CoarseLook LookOnCoarse(const FittedScene& coarse, bool is_first,
                          const DiagnosisOptions& options) const;
  std::optional<LocatedForce> Locate(const FittedScene& fitted, const Ranking& ranking,
                                     const DiagnosisOptions& options) const;
  // Empty where nothing is missing.
  std::optional<CoarseLook> LookForMissing();
  // Where, when and of what class a force is missing.
  void TellLocated(const std::optional<LocatedForce>& found);
  // Where an obstacle would stand that pushes as the missing force does.
  void FindContacts(const LocatedForce& found);
  void ForgetContacts(const RankedCandidate& kept);
  // A fault by which cameras and markers contradict each other, put right. False where there is
  // none.
  bool AddContradiction();
  struct Contradiction {
    RankedCandidate fault;
    double log_evidence;  // by what sources leave of each other, with and without it
  };
  std::optional<Ranking> CompareWithout(const RankedCandidate& fault, const Ranking& ranking) const;
  std::optional<Contradiction> Settle(RankedCandidate fault, const Ranking& ranking) const;
  std::optional<JudgedModel> PutRight(const Contradiction& found, const Ranking& ranking) const;
  // A round by forecasts; empty where there are none.
  std::optional<bool> AddByForecasts(const Ranking& ranking);
  bool AddByWholeFits(Ranking ranking, const std::vector<FittedModel>& models);
  std::vector<JudgedModel> FitWhole(const FittedScene& before,
                                    const std::vector<JudgedModel>& forecasts);
  void SettleContradiction(const JudgedModel& best_of_forecasts, std::vector<JudgedModel>* whole);
  bool IsBorneOut(const JudgedModel& best, const std::vector<JudgedModel>& whole) const;
  // The models that may be it, on the deciding mesh; what the recording speaks for most comes
  // first.
  std::vector<JudgedModel> Decide(const std::vector<FittedModel>& models);
  void GoOnWithTheBest(std::vector<JudgedModel>* judged) const;
  // A fit without the first one's effect, begun where it has ended, and all judged against that: if
  // the recording speaks for none any more, the model had found a lower minimum, not an effect.
  // True where the round has to be held again from there.
  bool CatchesUp(std::vector<JudgedModel>* judged);
  void Judge(const FittedScene& before, std::vector<JudgedModel>* judged) const;
  void Keep(std::vector<JudgedModel> judged, Ranking ranking);
  std::vector<Kept>::iterator FirstPhysics();
  // The newest effect, a fault, before all physics; does nothing where there is none.
  void PutFaultFirst();
  // What was kept by forecasts, fitted to all frames.
  void GoOnBeyondForecasts();
  FittedScene FitToEnd(FittedScene fine, int at_least) const;
  // A model like another one, fitted as that is: to forecasts or to all frames.
  std::optional<FittedScene> FitLike(const FittedScene& other, const ModelStart& start,
                                     int most_iterations) const;
  // What has two physical effects now: drops the first of them where the recording does not speak
  // for it beside the second, or puts a competitor in its place.
  void LookBack();
  std::optional<BothMeshes> OnBoth(const FittedScene& fine) const;
  void PutInPlaceOf(std::size_t first, std::vector<JudgedModel> both);
  void FitAgainWithoutFault();
  // before: the fit without, fitted as the model is.
  Model Describe(const JudgedModel& one, const FittedScene& before) const;
  void DescribeAll(const std::vector<JudgedModel>& judged, const FittedScene& before);
  // candidate: what the model has and the fit before has not, with the ranking that it is of.
  HeldOutValidation ValidateOn(const FittedScene& model, const FittedScene& before,
                               const RankedCandidate& candidate, const Ranking& ranking) const;
  // Physics that predicts the held-out frames worse than the fit without it explains nothing.
  bool PredictsWorse(const JudgedModel& model) const;
  // What else it could be, and what to record to know.
  void TellApart(const std::vector<JudgedModel>& judged);
  // What else the later effects could be.
  void TellSetsBeside();
  // A law instead of names, where those explain too little and it explains more.
  void LearnInstead();
  bool HasPhysics() const;
  double UnexplainedWithoutPhysics() const;  // beyond noise, sigmas
  void ForgetPhysics();
  void TakeBackWhatIsTooLittle();
  void SetAnswer(const BothMeshes& before);
  void MeasureWhatActs();
  void Conclude();
  // The answer by what is known now.
  void Answer();
  void TellFit();  // of the answer, with its motion
  // Keeps the answer so far, which takes longer to find than whoever interrupts it waits.
  void TellSoFar();
  // Where the physics begins: the fit without any, faults put right.
  const BothMeshes& WithoutPhysics() const;
  const Ranking& RankingWithoutPhysics() const;
  // Share of what a fit leaves beyond noise and mesh that is gone in another one.
  double Explained(const BothMeshes& before, const FittedScene& fine) const;
  bool IsLost() const;
  double ExplainedByAnswer() const;
  double MostOfAnswer() const;  // that has to be
  std::vector<std::string> EffectsSoFar() const;
  std::vector<std::string> ParametersSoFar() const;
  void Say(const std::string& stage, double fraction) const {
    if (options_.progress) options_.progress(stage, fraction);
  }
  void Log(const std::string& line) const {
    if (options_.log) options_.log(line);
  }
  bool Stopped() const { return runner_.IsStopped(); }
  void Spend(const std::string& stage);

  Recording recording_;
  FitConfig baseline_;
  const DiagnosisOptions& options_;
  FitRunner runner_;
  Meshes meshes_;
  Diagnosis diagnosis_;
  std::optional<Diagnosis> so_far_;  // after the last effect, as interrupted
  std::vector<std::string> swaps_;   // of markers, undone
  BothMeshes now_;                   // with everything that was kept
  std::vector<Kept> kept_;
  Ranking last_ranking_;                                  // of what was missing in now_
  Ranking contradictions_;                                // of sources, in now_
  std::optional<FitQuality> baseline_quality_, quality_;  // of the baseline and of now_
  int restarts_ = 0, rounds_left_ = 0;
  bool is_baseline_fitted_ = false;  // on the deciding mesh
  bool has_looked_ = false;          // for what is missing, beyond contradictions
  // What forecasts leave beyond noise, as costs: without physics, and with what was kept last.
  double forecasts_lack_ = 0.0, forecasts_left_ = 0.0;
  std::optional<MissingForce> missing_;
  std::vector<ContactShape> contacts_;  // that may make most of it
  std::chrono::steady_clock::time_point mark_ = std::chrono::steady_clock::now();
};

}  // namespace clothfit
