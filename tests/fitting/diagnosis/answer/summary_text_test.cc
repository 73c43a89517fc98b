// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Sentences that follow the numbers.
#include "fitting/diagnosis/answer/summary_text.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::Not;

Diagnosis LawThatExplains(double share) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNoneOfTheAbove;
  diagnosis.law.emplace();
  diagnosis.law->formula = "force per area along x = 0.3 N/m^2";
  diagnosis.law->model.explained = share;
  diagnosis.answer = diagnosis.law->model;
  return diagnosis;
}

TEST(SummaryText, OfALawTellsTheShareThatItExplains) {
  EXPECT_THAT(DescribeDiagnosis(LawThatExplains(0.62)),
              HasSubstr("The learned law: force per area along x = 0.3 N/m^2. It explains 62 % of "
                        "what the baseline cannot."));
}

// Of what mesh and step may make no share is known.
TEST(SummaryText, TellsNoShareThatMeshAndStepMayMake) {
  const std::string of_law = DescribeDiagnosis(LawThatExplains(0.0));
  EXPECT_THAT(of_law, HasSubstr("What mesh and step leave is as large as what it takes."));
  EXPECT_THAT(of_law, Not(HasSubstr("%")));
  Diagnosis of_fault;
  of_fault.verdict = Verdict::kObservationFault;
  of_fault.effects = of_fault.confidence_set = {"camera cam0: clock"};
  of_fault.answer.emplace();
  of_fault.answer->effects = of_fault.effects;
  of_fault.answer->log_evidence = 40.0;
  EXPECT_THAT(DescribeDiagnosis(of_fault),
              HasSubstr("What mesh and step leave is as large as what it takes; the natural "
                        "logarithm of the odds for it is 40."));
}

Diagnosis WindThatPredicts(double before, double after) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.effects = diagnosis.confidence_set = {"wind"};
  diagnosis.answer.emplace();
  diagnosis.answer->effects = {"wind"};
  diagnosis.answer->explained = 0.9;
  diagnosis.answer->validation.before = before;
  diagnosis.answer->validation.after = after;
  diagnosis.answer->validation.noise = 0.0026;
  return diagnosis;
}

// With the digits of the page's tiles, so that one number is one wherever it stands.
TEST(SummaryText, TellsHeldOutErrorsAsThePageDoes) {
  EXPECT_THAT(DescribeDiagnosis(WindThatPredicts(0.0243, 0.00312)),
              HasSubstr("With it, the error on the held-out frames falls from 24 mm to 3.1 mm; "
                        "noise is 2.6 mm."));
}

TEST(SummaryText, TellsWhatMeshAndStepMayMakeOfAFall) {
  Diagnosis diagnosis = WindThatPredicts(0.0243, 0.02);
  diagnosis.answer->validation.irreducible = 0.015;
  EXPECT_THAT(DescribeDiagnosis(diagnosis),
              HasSubstr("Mesh and step alone might make it fall to 19 mm."));
  diagnosis.answer->validation.irreducible = 0.03;
  EXPECT_THAT(DescribeDiagnosis(diagnosis), HasSubstr("Mesh and step alone might make all of it."));
}

TEST(SummaryText, WritesLargeOddsOut) {
  Diagnosis diagnosis = WindThatPredicts(0.0243, 0.02);
  diagnosis.answer->log_evidence = 1814.2;
  EXPECT_THAT(DescribeDiagnosis(diagnosis), HasSubstr("the odds for it is 1814."));
}

TEST(SummaryText, SaysWhatIsTakenOutOfSeveralEffects) {
  Diagnosis diagnosis = WindThatPredicts(0.0243, 0.00312);
  diagnosis.answer->effects = diagnosis.effects = {"wind", "bending_friction"};
  EXPECT_THAT(DescribeDiagnosis(diagnosis),
              HasSubstr("With bending friction besides, the error on the held-out frames falls"));
}

TEST(SummaryText, TellsNoErrorOfWhatBreaksDown) {
  const std::string words = DescribeDiagnosis(WindThatPredicts(HUGE_VAL, 0.00312));
  EXPECT_THAT(words, HasSubstr("Without it the simulation breaks down in the held-out frames; with "
                               "it the error there is 3.1 mm."));
  EXPECT_THAT(words, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace clothfit
