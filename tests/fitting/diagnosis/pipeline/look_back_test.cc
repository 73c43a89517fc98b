// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a second effect does to the first, and what becomes of an effect that explains too little or
// predicts worse, in states that few recordings bring about.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "tests/support/strip.h"

namespace clothfit {

// A diagnosis of a strip on one mesh whose effects are kept by hand.
class DiagnoserPeer {
 public:
  DiagnoserPeer(const Recording& recording, const std::vector<std::string>& terms)
      : options_(OnlyAmong(terms)),
        config_(Told(recording)),
        diagnoser_(recording, config_, options_) {
    base_ = FitBaseline(diagnoser_.recording_, config_, options_);
    ranking_ = RankCandidates(base_, options_);
    diagnoser_.meshes_.Set(base_, 9);
    diagnoser_.now_ = {base_, base_};
    diagnoser_.quality_ = diagnoser_.baseline_quality_ = AppraiseQuality(base_);
  }

  const FittedScene& base() const { return base_; }
  const FittedScene& now() const { return diagnoser_.now_.fine; }
  std::vector<std::string> effects() const { return diagnoser_.EffectsSoFar(); }

  // With the effect besides.
  JudgedModel Fit(const FittedScene& from, const std::string& effect) const {
    const RankedCandidate& candidate = Find(effect);
    const std::optional<FittedScene> fitted =
        FitModel(from, SwitchOn(from, candidate, ranking_.faults), 10, diagnoser_.runner_);
    if (!fitted) throw std::runtime_error("no fit with " + effect);
    return {candidate, {*fitted, *fitted}};
  }

  // As the newest effect, held against the others of its round.
  void Keep(const JudgedModel& model, const std::vector<JudgedModel>& round) {
    diagnoser_.kept_.push_back({model.candidate, diagnoser_.now_, ranking_, round});
    diagnoser_.now_ = model.model;
  }

  // Besides what is there, held against itself and these others.
  JudgedModel FitAndKeep(const std::string& effect, const std::vector<JudgedModel>& others = {}) {
    const JudgedModel model = Fit(now(), effect);
    std::vector<JudgedModel> round = {model};
    round.insert(round.end(), others.begin(), others.end());
    Keep(model, round);
    return model;
  }

  // A fault of a camera that changes nothing.
  void KeepFault(const std::string& name) {
    JudgedModel fault{{}, diagnoser_.now_};
    fault.candidate.summary.name = name;
    fault.candidate.faults = {0};
    Keep(fault, {fault});
  }

  double CostWithoutPhysics() const { return diagnoser_.WithoutPhysics().Cost(); }

  bool PredictsWorse(const JudgedModel& model) const { return diagnoser_.PredictsWorse(model); }
  void LookBack() { diagnoser_.LookBack(); }
  void PutFaultFirst() { diagnoser_.PutFaultFirst(); }
  void TakeBack() {
    diagnoser_.quality_ = AppraiseQuality(now());
    diagnoser_.TakeBackWhatIsTooLittle();
  }

 private:
  const RankedCandidate& Find(const std::string& effect) const {
    for (const RankedCandidate& one : ranking_.candidates)
      if (one.summary.name == effect) return one;
    throw std::invalid_argument("no candidate " + effect);
  }

  DiagnosisOptions options_;
  FitConfig config_;
  Diagnoser diagnoser_;
  FittedScene base_;
  Ranking ranking_;
};

namespace {

using testing::ElementsAre;

DiagnoserPeer Peer(const std::map<std::string, double>& effects) {
  return {MakeSyntheticRecording(Strip(effects)).recording, {"wind", "gravity_tilt", "hem"}};
}

// Tilt was kept for wind, which has been found since.
TEST(LookBack, DropsWhatTheSecondEffectDoesWithout) {
  DiagnoserPeer peer = Peer({{"wind.x", 3.0}});
  peer.FitAndKeep("gravity_tilt");
  peer.FitAndKeep("wind");
  peer.LookBack();
  EXPECT_THAT(peer.effects(), ElementsAre("wind"));
  EXPECT_EQ(peer.now().config.parameters.at("gravity_tilt.angle_1").free, false);
}

// Wind looks like a tilt as long as the hem is not known.
TEST(LookBack, PutsACompetitorInThePlaceOfTheFirst) {
  DiagnoserPeer peer = Peer({{"wind.x", 3.0}, {"hem.high_v", 0.03}});
  peer.FitAndKeep("gravity_tilt", {peer.Fit(peer.base(), "wind")});
  const JudgedModel both = peer.FitAndKeep("hem");
  peer.LookBack();
  EXPECT_THAT(peer.effects(), ElementsAre("wind", "hem"));
  EXPECT_LT(peer.now().fit.cost_after, both.model.Cost());
}

TEST(LookBack, LeavesTwoEffectsThatAreThere) {
  DiagnoserPeer peer = Peer({{"wind.x", 3.0}, {"hem.high_v", 0.03}});
  peer.FitAndKeep("wind", {peer.Fit(peer.base(), "gravity_tilt")});
  peer.FitAndKeep("hem");
  peer.LookBack();
  EXPECT_THAT(peer.effects(), ElementsAre("wind", "hem"));
}

// Wind is told of a recording that is put right, however late the camera was found.
TEST(PutFaultFirst, TellsOfPhysicsWithoutTheFault) {
  const std::string pose = "camera cam1: pose";
  DiagnoserPeer peer(SeenAskew({{"wind.x", 3.0}}, {0.03, -0.02, 0.0}), {"wind"});
  peer.FitAndKeep("wind");
  const JudgedModel both = peer.FitAndKeep(pose);
  ASSERT_THAT(peer.effects(), ElementsAre("wind", pose));
  ASSERT_EQ(peer.CostWithoutPhysics(), peer.base().fit.cost_after);
  peer.PutFaultFirst();
  EXPECT_THAT(peer.effects(), ElementsAre(pose, "wind"));
  EXPECT_LT(peer.CostWithoutPhysics(), 0.5 * peer.base().fit.cost_after);
  EXPECT_GT(peer.CostWithoutPhysics(), 1.5 * both.model.Cost());
  EXPECT_EQ(peer.now().fit.cost_after, both.model.Cost());
}

// A hem stands for little of a wind; the camera that was put right stays so.
TEST(TakeBack, OfPhysicsThatExplainsTooLittleLeavesTheFaults) {
  DiagnoserPeer peer = Peer({{"wind.x", 0.3}});
  peer.KeepFault("camera cam1: pose");
  const double before = peer.now().fit.cost_after;
  peer.FitAndKeep("hem");
  ASSERT_LT(peer.now().fit.cost_after, before);
  peer.TakeBack();
  EXPECT_THAT(peer.effects(), ElementsAre("camera cam1: pose"));
  EXPECT_EQ(peer.now().fit.cost_after, before);
}

TEST(TakeBack, LeavesPhysicsThatExplainsIt) {
  DiagnoserPeer peer = Peer({{"wind.x", 3.0}});
  peer.FitAndKeep("wind");
  peer.TakeBack();
  EXPECT_THAT(peer.effects(), ElementsAre("wind"));
}

// What was left out of one is what the other has; of a camera no physics is told.
TEST(PredictsWorse, IsOfPhysicsThatHoldsInFittedFramesAlone) {
  DiagnoserPeer peer = Peer({{"wind.x", 3.0}});
  const JudgedModel with = peer.Fit(peer.base(), "wind");
  EXPECT_FALSE(peer.PredictsWorse(with));
  peer.Keep(with, {with});
  JudgedModel without = {with.candidate, {peer.base(), peer.base()}};
  EXPECT_TRUE(peer.PredictsWorse(without));
  without.candidate.faults = {0};
  EXPECT_FALSE(peer.PredictsWorse(without));
}

}  // namespace
}  // namespace clothfit
