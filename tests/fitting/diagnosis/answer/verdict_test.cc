// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/verdict.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

Candidate Ranked(const char* name, CandidateKind kind) {
  Candidate candidate;
  candidate.name = name;
  candidate.kind = kind;
  return candidate;
}

// A baseline at its minimum that leaves something, with nothing found.
Diagnosis Unexplained() {
  Diagnosis diagnosis;
  diagnosis.ranking = {Ranked("wind", CandidateKind::kPhysics),
                       Ranked("camera cam0: pose", CandidateKind::kObservation)};
  diagnosis.gate_p_value = 1e-6;
  diagnosis.residual_rms = 1.5;
  diagnosis.promised = 0.001;
  return diagnosis;
}

TEST(Verdict, NamesPhysicsThatExplainsMostOfIt) {
  Diagnosis diagnosis = Unexplained();
  diagnosis.effects = {"camera cam0: pose", "wind"};
  EXPECT_EQ(VerdictOf(diagnosis, 0.95, true), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, 0.85, true), Verdict::kNoneOfTheAbove);
}

TEST(Verdict, NamesWhatExplainsHalfWhereNoFitComesNearTheNull) {
  Diagnosis diagnosis = Unexplained();
  diagnosis.effects = {"wind"};
  diagnosis.residual_rms = 20.0;
  diagnosis.baseline_fit.cost_after = 1000.0;
  diagnosis.answer.emplace();
  diagnosis.answer->cost = 400.0;  // 12.6 sigmas
  EXPECT_EQ(VerdictOf(diagnosis, 0.6, true), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, 0.4, true), Verdict::kNoneOfTheAbove);
  diagnosis.answer->cost = 200.0;  // 8.9 sigmas
  EXPECT_EQ(VerdictOf(diagnosis, 0.6, true), Verdict::kNoneOfTheAbove);
}

TEST(Verdict, WhatWasAnErrorOfTheMeshDoesNotStandOnAFinerOne) {
  EXPECT_TRUE(StandsOnFinerMesh(1000.0, 900.0));
  EXPECT_TRUE(StandsOnFinerMesh(1000.0, 2000.0));  // it may be seen better there
  EXPECT_FALSE(StandsOnFinerMesh(1000.0, 200.0));
  EXPECT_FALSE(StandsOnFinerMesh(1000.0, -50.0));
}

TEST(Verdict, BlamesTheObservationWhereNothingElseWasFound) {
  Diagnosis diagnosis = Unexplained();
  diagnosis.effects = {"camera cam0: pose"};
  EXPECT_EQ(VerdictOf(diagnosis, 0.2, true), Verdict::kObservationFault);
  diagnosis.effects = {"markers 3 and 4 swapped from frame 7 on"};  // ranked nowhere
  EXPECT_EQ(VerdictOf(diagnosis, 0.2, true), Verdict::kObservationFault);
}

TEST(Verdict, OfNothingFoundDependsOnWhatIsLeft) {
  const Diagnosis diagnosis = Unexplained();
  EXPECT_EQ(VerdictOf(diagnosis, 0.0, true), Verdict::kNoneOfTheAbove);
  EXPECT_EQ(VerdictOf(diagnosis, 0.0, false), Verdict::kNothingMissing);  // mesh and step
  Diagnosis passed = diagnosis;
  passed.gate_p_value = 0.3;
  EXPECT_EQ(VerdictOf(passed, 0.0, true), Verdict::kNothingMissing);
}

TEST(Verdict, IsOpenWhereTheFitCannotTell) {
  Diagnosis rugged = Unexplained();
  rugged.promised = 0.2;
  EXPECT_EQ(VerdictOf(rugged, 0.0, true), Verdict::kUndecided);
  Diagnosis far = Unexplained();
  far.residual_rms = 3.0;
  EXPECT_EQ(VerdictOf(far, 0.0, false), Verdict::kUndecided);
  EXPECT_EQ(VerdictOf(far, 0.0, true), Verdict::kNoneOfTheAbove);
}

// Of a fit that costs 100, all of which is missing.
Model Explaining(double share, bool is_validated) {
  Model model;
  model.explained = share;
  model.cost = 100.0 * (1.0 - share);
  model.validation.is_validated = is_validated;
  return model;
}

TEST(ChooseModel, TakesTheFirstThatIsValidated) {
  const std::vector<Model> models = {Explaining(0.9, true), Explaining(0.8, false),
                                     Explaining(0.05, true), Explaining(0.6, true)};
  const auto validated = ChooseModel(models, 1, {100.0, 0.1, true});
  ASSERT_TRUE(validated);
  EXPECT_EQ(validated->model, 3u);
  EXPECT_TRUE(validated->is_kept);
  const auto unasked = ChooseModel(models, 1, {100.0, 0.1, false});
  ASSERT_TRUE(unasked);
  EXPECT_EQ(unasked->model, 1u);
  EXPECT_TRUE(unasked->is_kept);
}

TEST(ChooseModel, TheFirstDeservesAnotherTestOnlyWhereItCostsFarLess) {
  const ChoiceRules rules{100.0, 0.1, true};
  const Model kept = Explaining(0.5, true);
  EXPECT_TRUE(FirstDeservesAnotherTest({Explaining(0.7, false), kept}, 0, rules));
  EXPECT_FALSE(FirstDeservesAnotherTest({Explaining(0.55, false), kept}, 0, rules));
  EXPECT_FALSE(FirstDeservesAnotherTest({Explaining(0.7, true), kept}, 0, rules));
  EXPECT_FALSE(FirstDeservesAnotherTest({Explaining(0.7, false)}, 0, rules));  // none is kept
  EXPECT_TRUE(FirstDeservesAnotherTest({kept, Explaining(0.7, false), kept}, 1, rules));
  EXPECT_FALSE(FirstDeservesAnotherTest({}, 0, rules));
}

// A camera that moved explains some of whatever is wrong with a cloth.
TEST(ChooseModel, KeepsNothingThatGainsFarLessThanTheBest) {
  const std::vector<Model> models = {Explaining(0.8, false), Explaining(0.3, true)};
  const auto chosen = ChooseModel(models, 0, {100.0, 0.1, true});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->model, 0u);
  EXPECT_FALSE(chosen->is_kept);
}

TEST(ChooseModel, LooksAtTheBestLocalMinimumWhereNothingIsValidated) {
  const std::vector<Model> models = {Explaining(0.3, false), Explaining(0.8, false)};
  const auto best = ChooseModel(models, 0, {100.0, 0.1, true});
  ASSERT_TRUE(best);
  EXPECT_EQ(best->model, 0u);
  EXPECT_FALSE(best->is_kept);
  EXPECT_FALSE(ChooseModel(models, 0, {100.0, 0.5, true}));  // the best comes first
  EXPECT_FALSE(ChooseModel(models, 2, {100.0, 0.1, true}));  // no models in this round
}

TEST(Law, TakesThePlaceOfNamesThatExplainLessOrPredictWorse) {
  HeldOutValidation law, names;
  law.after = 4.7;
  names.after = 14.3;
  EXPECT_TRUE(TakesPlace(law, 0.74, &names, 0.77));
  EXPECT_FALSE(TakesPlace(law, 0.60, &names, 0.77));
  EXPECT_TRUE(TakesPlace(names, 0.88, &law, 0.77));
  EXPECT_FALSE(TakesPlace(names, 0.80, &law, 0.77));
  EXPECT_TRUE(TakesPlace(law, 0.96, &law, 0.92));  // half of what is left
  EXPECT_FALSE(TakesPlace(law, 0.74, nullptr, 0.77));
  EXPECT_TRUE(TakesPlace(law, 0.2, nullptr, 0.0));
  names.is_against_others = true;  // of something else
  EXPECT_FALSE(TakesPlace(law, 0.74, &names, 0.77));
}

TEST(Verdict, OfALawIsNoneOfTheAbove) {
  Diagnosis diagnosis = Unexplained();
  diagnosis.effects = {"wind"};
  diagnosis.law.emplace();
  EXPECT_EQ(VerdictOf(diagnosis, 0.9, true), Verdict::kNoneOfTheAbove);
}

}  // namespace
}  // namespace clothfit
