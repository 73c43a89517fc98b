// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Sentences that follow the numbers.
#include "fitting/diagnosis/answer/summary_text.h"

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

}  // namespace
}  // namespace clothfit
