// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/verdict.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

Outcome WithPhysics(double explained, double unexplained) {
  return {true, false, explained, unexplained, 0.0, MostOfIt(unexplained)};
}

TEST(Verdict, NamesPhysicsThatExplainsMostOfIt) {
  const Diagnosis diagnosis;
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.95, 1.5)), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.85, 1.5)), Verdict::kNoneOfTheAbove);
}

TEST(Verdict, NamesPhysicsThatLeavesTooLittleToAskFor) {
  const Diagnosis diagnosis;
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.85, 0.9)), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, {true, true, 0.85, 1.5}), Verdict::kNamed);
  // The residual may be discretisation error.
  EXPECT_EQ(VerdictOf(diagnosis, {true, false, 0.85, 1.5, 2.0}), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, {true, false, 0.85, 1.5, 1.2}), Verdict::kNoneOfTheAbove);
  EXPECT_EQ(VerdictOf(diagnosis, {true, false, 0.4, 1.5, 2.0}), Verdict::kNoneOfTheAbove);
}

// Half of the interval would be a patch that is heavier, the other half one that is lighter.
TEST(Verdict, NamesNoPhysicsWhoseAmountsMayBeNone) {
  Diagnosis diagnosis;
  diagnosis.answer.emplace();
  diagnosis.answer->parameters = {{"heavy_patch.share", "1", -0.7, -0.9, 0.2},
                                  {"heavy_patch.u", "m", 0.4, 0.3, 0.5}};
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.95, 1.5)), Verdict::kNoneOfTheAbove);
  diagnosis.answer->parameters[0].upper90 = -0.1;
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.95, 1.5)), Verdict::kNamed);
  // One of several is enough: wind blows along one axis.
  diagnosis.answer->parameters.push_back({"wind.x", "m/s", 0.0, -0.1, 0.1});
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.95, 1.5)), Verdict::kNamed);
}

TEST(Verdict, NamesWhatExplainsHalfOfForecastsWhereTheMotionIsLost) {
  EXPECT_EQ(MostOfIt(3.0), 0.9);
  EXPECT_EQ(MostOfIt(3.0, true), 0.5);
}

TEST(Verdict, NamesWhatExplainsHalfWhereNoFitComesNear) {
  const Diagnosis diagnosis;
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.6, 12.6)), Verdict::kNamed);
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.4, 12.6)), Verdict::kNoneOfTheAbove);
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.6, 8.9)), Verdict::kNoneOfTheAbove);
}

TEST(Verdict, BlamesTheObservationWhereNothingElseWasFound) {
  Diagnosis diagnosis;
  diagnosis.effects = {"camera cam0: pose"};
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.2, 1.5}), Verdict::kObservationFault);
}

TEST(Verdict, OfNothingFoundDependsOnWhatIsLeft) {
  Diagnosis diagnosis;
  EXPECT_EQ(VerdictOf(diagnosis, {false, true, 0.0, 3.0}), Verdict::kNothingMissing);
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 0.9}), Verdict::kNothingMissing);
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 1.1}), Verdict::kNoneOfTheAbove);
  diagnosis.promised = 0.2;  // of all; a third of what is beyond noise
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 1.1}), Verdict::kNoneOfTheAbove);
  diagnosis.promised = 0.4;
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 1.1}), Verdict::kUndecided);
}

// Twins of a finer mesh lack nothing.
TEST(Verdict, IsOpenWhereMeshAndStepMayLeaveAsMuch) {
  Diagnosis diagnosis;
  diagnosis.gate_p_value = 0.4;
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 1.6}), Verdict::kUndecided);
  EXPECT_EQ(VerdictOf(diagnosis, WithPhysics(0.95, 1.5)), Verdict::kNamed);
  diagnosis.gate_p_value = 0.001;
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 1.6}), Verdict::kNoneOfTheAbove);
}

// Where D is known, whatever the coarse mesh says.
TEST(Verdict, IsOpenWhereTheDecidingMeshMayMakeIt) {
  Diagnosis diagnosis;
  diagnosis.gate_p_value = 0.4;
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 4.2, 2.2}), Verdict::kNoneOfTheAbove);
  diagnosis.gate_p_value = 0.001;
  EXPECT_EQ(VerdictOf(diagnosis, {false, false, 0.0, 4.2, 4.3}), Verdict::kUndecided);
}

TEST(Verdict, OfALawIsNoneOfTheAbove) {
  Diagnosis diagnosis;
  diagnosis.effects = {"law_air"};
  diagnosis.law.emplace();
  EXPECT_EQ(VerdictOf(diagnosis, {false, true, 0.99, 0.1}), Verdict::kNoneOfTheAbove);
}

}  // namespace
}  // namespace clothfit
